// The playground in `dist`: the bundled page, Pyodide, the packages and the gallery.
//
// `PYTHON` is a Python with the package's libraries and setuptools; without it that of ../.venv.

import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, rmSync } from "node:fs";
import { build } from "esbuild";

const PYODIDE = ["pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip", "pyodide-lock.json"];
const PAGE = ["index.html", "scope.html", "style.css", "icon.svg", "runner.py", "language.py", "worker.js"];

// The libraries of contents.py, and the version of setuptools in pyproject.toml.
const NEEDS = "import setuptools, pip, lark, numpy; assert int(setuptools.__version__.split('.')[0]) >= 77";

process.chdir(import.meta.dirname);
const local = "../.venv/bin/python";
const python = process.env.PYTHON ?? (existsSync(local) ? local : "python3");
try {
  execFileSync(python, ["-c", NEEDS], { stdio: "ignore" });
} catch {
  console.error(`${python} cannot build the playground: set PYTHON to a Python 3.11 or later with pip, setuptools 77 or later, and motionlang's libraries`);
  process.exit(1);
}
rmSync("dist", { recursive: true, force: true });
mkdirSync("dist/pyodide", { recursive: true });
await build({ entryPoints: ["main.js"], outdir: "dist", bundle: true, splitting: true, minify: true, format: "esm", target: "es2022", legalComments: "linked" });
for (const name of PAGE) cpSync(name, `dist/${name}`);
for (const name of PYODIDE) cpSync(`node_modules/pyodide/${name}`, `dist/pyodide/${name}`);
execFileSync(python, ["contents.py", "dist"], { stdio: "inherit" });
