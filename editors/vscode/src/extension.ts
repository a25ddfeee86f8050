// The extension: starts the language server, and the commands of its lenses.

import { execFile } from "node:child_process";
import * as path from "node:path";
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/node";
import { CoverageMarks } from "./coverage";
import { findPython } from "./python";
import { ScopePage } from "./scope";

// Tasks with equal definitions are the same one, and may not run twice at a time.
let tasks = 0;
const COMMANDS = ["motionlang.run", "motionlang.profile", "motionlang.scope", "motionlang.debug", "motionlang.map"];
let client: LanguageClient | undefined;
let differences: vscode.OutputChannel | undefined;
let python: string | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const on = (name: string, action: (uri?: string | vscode.Uri, unit?: string) => unknown): void => {
    context.subscriptions.push(vscode.commands.registerCommand(name, action));
  };
  on("motionlang.run", (uri) => inTerminal(uri, (file) => ["run", file]));
  on("motionlang.map", (uri, unit) => inTerminal(uri, (file) => ["map", file, ...(unit ? ["--unit", unit] : [])]));
  on("motionlang.profile", (uri) => inTerminal(uri, (file) => ["profile", file]));
  const page = new ScopePage(
    () => storage(context, "scope.html"),
    (program, file, words) => inTerminal(program, (path) => ["plot", path, file.fsPath, ...words], false),
  );
  on("motionlang.scope", async (uri) => {
    const file = fileOf(uri);
    return file && page.show(file);
  });
  const marks = new CoverageMarks(coverage);
  on("motionlang.cover", async (uri) => {
    const file = await saved(uri);
    return file && marks.show(vscode.Uri.file(file));
  });
  on("motionlang.diff", (uri) => compareWithSaved(context, uri));
  on("motionlang.debug", debug);
  on("motionlang.restart", restart);
  const adapter: vscode.DebugAdapterDescriptorFactory = { createDebugAdapterDescriptor };
  const configurations: vscode.DebugConfigurationProvider = { resolveDebugConfiguration };
  context.subscriptions.push(
    marks,
    vscode.debug.registerDebugAdapterDescriptorFactory("motionlang", adapter),
    vscode.debug.registerDebugConfigurationProvider("motionlang", configurations),
    vscode.debug.registerDebugAdapterTrackerFactory("motionlang", page),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("motionlang")) {
        void restart();
      }
    }),
  );
  await restart();
}

export async function deactivate(): Promise<void> {
  differences?.dispose();
  await client?.stop();
}

async function restart(): Promise<void> {
  await client?.stop();
  client = undefined;
  python = await findPython();
  if (!python) {
    return;
  }
  const server = { command: python, args: ["-m", "motionlang", "lsp"] };
  client = new LanguageClient("motionlang", "motionlang", server, {
    documentSelector: [{ language: "mint" }, { language: "mccl" }, { pattern: "**/*.machine.toml" }],
    initializationOptions: { commands: COMMANDS },
    synchronize: { fileEvents: vscode.workspace.createFileSystemWatcher("**/*.machine.toml") },
  });
  await client.start();
}

/** The file that a lens or a menu names, or that of the active editor. */
function fileOf(uri?: string | vscode.Uri): vscode.Uri | undefined {
  return typeof uri === "string" ? vscode.Uri.parse(uri) : (uri ?? vscode.window.activeTextEditor?.document.uri);
}

/** Saves the program and returns its path. */
async function saved(uri?: string | vscode.Uri): Promise<string | undefined> {
  const file = fileOf(uri);
  if (!file || file.scheme !== "file") {
    void vscode.window.showWarningMessage("save the program first");
    return undefined;
  }
  await vscode.workspace.textDocuments.find((each) => each.uri.toString() === file.toString())?.save();
  return file.fsPath;
}

/** Saves a program and runs a command with it; returns the status. */
async function inTerminal(
  uri: string | vscode.Uri | undefined,
  command: (file: string) => string[],
  shown = true,
): Promise<number | undefined> {
  const file = await saved(uri);
  return file === undefined ? undefined : runTask(command(file), path.dirname(file), shown);
}

/** Runs a command in a terminal that stays open; returns the status. */
async function runTask(words: string[], folder: string, shown = true): Promise<number | undefined> {
  python ??= await findPython();
  if (!python) {
    return undefined;
  }
  const execution = new vscode.ProcessExecution(python, ["-m", "motionlang", ...words], { cwd: folder });
  const definition = { type: "motionlang", command: words[0], number: ++tasks };
  const task = new vscode.Task(definition, vscode.TaskScope.Workspace, words[0], "motionlang", execution);
  const reveal = shown ? vscode.TaskRevealKind.Always : vscode.TaskRevealKind.Silent;
  task.presentationOptions = { reveal, clear: true, showReuseMessage: false };
  return new Promise((done, failed) => {
    const ended = vscode.tasks.onDidEndTaskProcess((event) => {
      if (event.execution.task.definition.number === definition.number) {
        ended.dispose();
        done(event.exitCode);
      }
    });
    vscode.tasks.executeTask(task).then(undefined, failed);
  });
}

async function compareWithSaved(context: vscode.ExtensionContext, uri?: string | vscode.Uri): Promise<void> {
  const file = fileOf(uri);
  const document = vscode.workspace.textDocuments.find((each) => each.uri.toString() === file?.toString());
  if (!file || !document) {
    return;
  }
  const edited = await storage(context, `edited${path.extname(file.fsPath)}`);
  await vscode.workspace.fs.writeFile(edited, Buffer.from(document.getText(), "utf8"));
  const machine = file.fsPath.slice(0, -path.extname(file.fsPath).length) + ".machine.toml";
  const words = (await exists(machine)) ? ["--machine-b", machine] : [];
  python ??= await findPython();
  if (!python) {
    return;
  }
  // A task would save the program first.
  const command = ["-m", "motionlang", "diff", file.fsPath, edited.fsPath, ...words];
  execFile(python, command, { cwd: path.dirname(file.fsPath) }, (_error, output, errors) => {
    differences ??= vscode.window.createOutputChannel("motionlang diff");
    differences.replace(output + errors);
    differences.show(true);
  });
}

/** Returns what `motionlang cover` prints about a program; it says why if that is nothing. */
async function coverage(program: vscode.Uri): Promise<string | undefined> {
  python ??= await findPython();
  if (!python) {
    return undefined;
  }
  const command = ["-m", "motionlang", "cover", program.fsPath, "--format", "json"];
  return new Promise((done) => {
    execFile(python!, command, { cwd: path.dirname(program.fsPath), maxBuffer: 1 << 26 }, (error, output, errors) => {
      if (error) {
        void vscode.window.showWarningMessage(errors.split("\n")[0] || "the program has no coverage");
      }
      done(error ? undefined : output);
    });
  });
}

async function exists(file: string): Promise<boolean> {
  try {
    await vscode.workspace.fs.stat(vscode.Uri.file(file));
    return true;
  } catch {
    return false;
  }
}

async function storage(context: vscode.ExtensionContext, name: string): Promise<vscode.Uri> {
  await vscode.workspace.fs.createDirectory(context.globalStorageUri);
  return vscode.Uri.joinPath(context.globalStorageUri, name);
}

async function debug(uri?: string | vscode.Uri): Promise<void> {
  const program = await saved(uri);
  if (program) {
    const folder = vscode.workspace.getWorkspaceFolder(vscode.Uri.file(program));
    await vscode.debug.startDebugging(folder, { type: "motionlang", request: "launch", name: "Debug program", program });
  }
}

async function createDebugAdapterDescriptor(): Promise<vscode.DebugAdapterDescriptor | undefined> {
  python ??= await findPython();
  return python ? new vscode.DebugAdapterExecutable(python, ["-m", "motionlang", "dap"]) : undefined;
}

/** Lets F5 work without a launch.json. */
function resolveDebugConfiguration(
  _folder: vscode.WorkspaceFolder | undefined,
  configuration: vscode.DebugConfiguration,
): vscode.DebugConfiguration | undefined {
  const document = vscode.window.activeTextEditor?.document;
  if (!configuration.type && (document?.languageId === "mint" || document?.languageId === "mccl")) {
    return { type: "motionlang", request: "launch", name: "Debug program", program: document.uri.fsPath };
  }
  return configuration;
}
