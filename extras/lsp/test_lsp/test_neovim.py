"""Headless Neovim with the settings of docs/editor.md."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from test_lsp.conftest import MAX_SECONDS, ROOT

NEOVIM = shutil.which("nvim")
PROGRAM = """\
Dim count As Integer
SPEDE = 3
count = count + 1
MOVER = 1 : GO
Print “x”, count
"""
# Waits for diagnostics, applies the two quick fixes, gives a name, and writes what it saw.
STEPS = """\
local function wait(ready) assert(vim.wait(60000, ready, 20), "nothing came in time") end
local function messages()
  local found = {}
  for _, each in ipairs(vim.diagnostic.get(0)) do found[#found + 1] = each.message end
  table.sort(found)
  return found
end
local function request(method, parameters)
  for _, answer in pairs(assert(vim.lsp.buf_request_sync(0, method, parameters, 60000))) do
    assert(not answer.err, vim.inspect(answer.err))
    return answer.result
  end
end

wait(function() return #vim.diagnostic.get(0) == 2 end)
local seen = { before = messages() }
local document = { uri = vim.uri_from_bufnr(0) }
local lines = { start = { line = 0, character = 0 }, ["end"] = { line = 9, character = 0 } }
for number = 1, 2 do
  local tick = vim.api.nvim_buf_get_changedtick(0)
  local offered = request("textDocument/codeAction",
    { textDocument = document, range = lines, context = { diagnostics = {} } })
  vim.lsp.util.apply_workspace_edit(offered[1].edit, "utf-16")
  wait(function() return vim.api.nvim_buf_get_changedtick(0) > tick end)
  local left = #seen.before - number
  wait(function() return #vim.diagnostic.get(0) <= left end)
end
seen.after = messages()
local edit = request("textDocument/rename",
  { textDocument = document, position = { line = 0, character = 5 }, newName = "done" })
vim.lsp.util.apply_workspace_edit(edit, "utf-16")
seen.lines = vim.api.nvim_buf_get_lines(0, 0, -1, true)
local file = io.open(os.getenv("SEEN"), "w")
file:write(vim.fn.json_encode(seen))
file:close()
"""


@pytest.mark.skipif(NEOVIM is None, reason="Neovim is not installed")
def test_neovim_shows_diagnostics_applies_fixes_and_renames(tmp_path: Path) -> None:
    assert NEOVIM is not None
    page = (ROOT / "docs" / "editor.md").read_text(encoding="utf-8")
    settings = re.findall(r"^```lua\n(.*?)^```$", page, re.MULTILINE | re.DOTALL)[1]
    (tmp_path / "motionlang").write_text(
        f'#!/bin/sh\nPYTHONPATH={ROOT} exec {sys.executable} -m motionlang "$@"\n', encoding="utf-8"
    )
    (tmp_path / "motionlang").chmod(0o755)
    (tmp_path / "init.lua").write_text(settings, encoding="utf-8")
    steps = STEPS.replace("\n", "\n  ")
    (tmp_path / "steps.lua").write_text(
        f"local done, why = pcall(function()\n  {steps}\nend)\n"
        'if not done then io.stderr:write(tostring(why)) end\nvim.cmd(done and "qall!" or "cquit!")\n',
        encoding="utf-8",
    )
    (tmp_path / "a.mnt").write_text(PROGRAM, encoding="utf-8")
    own = {name: str(tmp_path / name) for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME")}
    done = subprocess.run(
        [NEOVIM, "--headless", "-n", "-u", "init.lua", "a.mnt", "-S", "steps.lua"],
        cwd=tmp_path,
        env={**os.environ, **own, "PATH": f"{tmp_path}{os.pathsep}{os.environ['PATH']}", "SEEN": "seen.json"},
        capture_output=True,
        text=True,
        timeout=4 * MAX_SECONDS,
        check=False,
    )
    assert done.returncode == 0, done.stderr
    seen = json.loads((tmp_path / "seen.json").read_text(encoding="utf-8"))
    assert [each.partition("\n")[0] for each in seen["before"]] == [
        "SPEDE is assigned but never read",
        '“ is a typographic quote, not a plain "',
    ]
    assert seen["after"] == []
    assert seen["lines"] == [
        "Dim done As Integer",
        "SPEED = 3",
        "done = done + 1",
        "MOVER = 1 : GO",
        'Print "x", done',
    ]
