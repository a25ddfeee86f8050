// Finds the Python that has motionlang.

import { execFile } from "node:child_process";
import * as vscode from "vscode";

const INSTALL = "python -m pip install . ./extras/lsp";
/** The longest time that a Python may take to answer, in milliseconds. */
const LIMIT = 20_000;

/** Returns the Python to start motionlang with, or undefined after saying how to install it. */
export async function findPython(): Promise<string | undefined> {
  const tried: string[] = [];
  for (const python of await candidates()) {
    if (await hasMotionlang(python)) {
      return python;
    }
    tried.push(python);
  }
  const text = `motionlang-lsp is not installed in ${tried.join(", ") || "any Python"}; in a clone of motionlang: ${INSTALL}`;
  const copy = "Copy the command", settings = "Open the setting";
  void vscode.window.showWarningMessage(text, copy, settings).then((chosen) => {
    if (chosen === copy) {
      void vscode.env.clipboard.writeText(INSTALL);
    } else if (chosen === settings) {
      void vscode.commands.executeCommand("workbench.action.openSettings", "motionlang.python");
    }
  });
  return undefined;
}

/** The setting alone if there is one, then the Python extension's choice, then those of the path. */
async function candidates(): Promise<string[]> {
  const set = vscode.workspace.getConfiguration("motionlang").get<string>("python", "");
  if (set) {
    return [set];
  }
  const chosen = await chosenPython();
  return [...(chosen ? [chosen] : []), "python3", "python"];
}

async function chosenPython(): Promise<string | undefined> {
  const extension = vscode.extensions.getExtension("ms-python.python");
  if (!extension) {
    return undefined;
  }
  try {
    const api = await extension.activate();
    const folder = vscode.workspace.workspaceFolders?.[0]?.uri;
    const path = api?.environments?.getActiveEnvironmentPath?.(folder);
    const environment = path && (await api.environments.resolveEnvironment(path));
    return environment?.executable?.uri?.fsPath ?? undefined;
  } catch {
    return undefined; // without it the path is searched
  }
}

function hasMotionlang(python: string): Promise<boolean> {
  return new Promise((done) => {
    execFile(python, ["-c", "import motionlang_lsp.server"], { timeout: LIMIT }, (error) => done(!error));
  });
}
