// The extension: starts the language server, and the commands of its lenses.

import * as path from "node:path";
import * as vscode from "vscode";
import { LanguageClient } from "vscode-languageclient/node";
import { findPython } from "./python";

const COMMANDS = ["motionlang.run", "motionlang.profile", "motionlang.scope", "motionlang.debug"];
let client: LanguageClient | undefined;
let python: string | undefined;

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const on = (name: string, action: (uri?: string | vscode.Uri) => unknown): void => {
    context.subscriptions.push(vscode.commands.registerCommand(name, action));
  };
  on("motionlang.run", (uri) => inTerminal(uri, (file) => ["run", file]));
  on("motionlang.profile", (uri) => inTerminal(uri, (file) => ["run", file, "--profile"]));
  on("motionlang.scope", (uri) => showPage(context, uri));
  on("motionlang.diff", (uri) => compareWithSaved(context, uri));
  on("motionlang.debug", debug);
  on("motionlang.restart", restart);
  const adapter: vscode.DebugAdapterDescriptorFactory = { createDebugAdapterDescriptor };
  const configurations: vscode.DebugConfigurationProvider = { resolveDebugConfiguration };
  context.subscriptions.push(
    vscode.debug.registerDebugAdapterDescriptorFactory("motionlang", adapter),
    vscode.debug.registerDebugConfigurationProvider("motionlang", configurations),
    vscode.workspace.onDidChangeConfiguration((change) => {
      if (change.affectsConfiguration("motionlang")) {
        void restart();
      }
    }),
  );
  await restart();
}

export async function deactivate(): Promise<void> {
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

async function inTerminal(
  uri: string | vscode.Uri | undefined,
  command: (file: string) => string[],
): Promise<number | undefined> {
  const file = await saved(uri);
  python ??= await findPython();
  if (!file || !python) {
    return undefined;
  }
  const words = command(file);
  const execution = new vscode.ProcessExecution(python, ["-m", "motionlang", ...words], { cwd: path.dirname(file) });
  const task = new vscode.Task({ type: "motionlang", command: words[0] }, vscode.TaskScope.Workspace, words[0], "motionlang", execution);
  const started = await vscode.tasks.executeTask(task);
  return new Promise((done) => {
    const ended = vscode.tasks.onDidEndTaskProcess((event) => {
      if (event.execution === started) {
        ended.dispose();
        done(event.exitCode);
      }
    });
  });
}

async function showPage(context: vscode.ExtensionContext, uri?: string | vscode.Uri): Promise<void> {
  const page = await storage(context, "scope.html");
  await inTerminal(uri, (file) => ["run", file, "--plot", page.fsPath]);
  try {
    const text = Buffer.from(await vscode.workspace.fs.readFile(page)).toString("utf8");
    const panel = vscode.window.createWebviewPanel("motionlang.scope", "motion", vscode.ViewColumn.Beside, {
      enableScripts: true,
    });
    panel.webview.html = text;
  } catch {
    void vscode.window.showWarningMessage("the run has written no page; its terminal shows why");
  }
}

async function compareWithSaved(context: vscode.ExtensionContext, uri?: string | vscode.Uri): Promise<void> {
  const file = fileOf(uri);
  const document = vscode.workspace.textDocuments.find((each) => each.uri.toString() === file?.toString());
  if (!file || !document) {
    return;
  }
  const edited = await storage(context, `edited${path.extname(file.fsPath)}`);
  await vscode.workspace.fs.writeFile(edited, Buffer.from(document.getText(), "utf8"));
  python ??= await findPython();
  if (!python) {
    return;
  }
  const terminal = vscode.window.createTerminal("motionlang diff", python, ["-m", "motionlang", "diff", file.fsPath, edited.fsPath]);
  terminal.show();
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
