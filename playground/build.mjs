// The playground in `dist`: the bundled page, Pyodide, the packages and the gallery.
//
// `PYTHON` is a Python with the package's libraries and setuptools; without it that of ../.venv.

import { execFileSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, rmSync } from "node:fs";
import { build } from "esbuild";

const PYODIDE = ["pyodide.mjs", "pyodide.asm.mjs", "pyodide.asm.wasm", "python_stdlib.zip", "pyodide-lock.json"];
const PAGE = ["index.html", "scope.html", "style.css", "icon.svg", "runner.py", "language.py", "worker.js"];

process.chdir(import.meta.dirname);
rmSync("dist", { recursive: true, force: true });
mkdirSync("dist/pyodide", { recursive: true });
await build({ entryPoints: ["main.js"], outdir: "dist", bundle: true, splitting: true, minify: true, format: "esm", target: "es2022", legalComments: "linked" });
for (const name of PAGE) cpSync(name, `dist/${name}`);
for (const name of PYODIDE) cpSync(`node_modules/pyodide/${name}`, `dist/pyodide/${name}`);
const local = "../.venv/bin/python";
execFileSync(process.env.PYTHON ?? (existsSync(local) ? local : "python3"), ["contents.py", "dist"], { stdio: "inherit" });
