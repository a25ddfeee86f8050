// The page of the motion: one panel, whose cursor is at the time of the debugger's stop.

import * as vscode from "vscode";

/** Writes the page of a program into a file; the words are further arguments of `motionlang plot`. */
export type Draw = (program: vscode.Uri, page: vscode.Uri, words: string[]) => Promise<unknown>;

/** The arguments of a launch that `motionlang run` has too. */
const OPTIONS = ["machine", "lang", "until", "input", "analog", "answer", "keys"];

export class ScopePage implements vscode.DebugAdapterTrackerFactory {
  private panel: vscode.WebviewPanel | undefined;
  private program: vscode.Uri | undefined;

  constructor(
    private readonly file: () => Promise<vscode.Uri>,
    private readonly draw: Draw,
  ) {}

  /** Runs a program and shows its motion. */
  async show(program: vscode.Uri): Promise<void> {
    const session = vscode.debug.activeDebugSession;
    const words = session && isOf(session, program) ? options(session.configuration) : [];
    this.program = program;
    const page = await this.file();
    try {
      await vscode.workspace.fs.delete(page);
    } catch {
      // there is none yet
    }
    await this.draw(program, page, words);
    let text: string;
    try {
      text = Buffer.from(await vscode.workspace.fs.readFile(page)).toString("utf8");
    } catch {
      void vscode.window.showWarningMessage("the run has written no page; its terminal shows why");
      return;
    }
    if (!this.panel) {
      this.panel = vscode.window.createWebviewPanel(
        "motionlang.scope",
        "motion",
        { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true },
        { enableScripts: true, retainContextWhenHidden: true },
      );
      this.panel.onDidDispose(() => (this.panel = undefined));
      this.panel.webview.onDidReceiveMessage(() => this.begin());
    }
    this.panel.title = `motion of ${program.path.split("/").pop()}`;
    // The page reports when it can be told the time of the stop.
    this.panel.webview.html = text.replace(/<\/body>/, "<script>acquireVsCodeApi().postMessage({})</script></body>");
  }

  createDebugAdapterTracker(session: vscode.DebugSession): vscode.DebugAdapterTracker {
    return {
      onDidSendMessage: (message: { type: string; event?: string; command?: string; success?: boolean }) => {
        if (!this.panel || !this.program || !isOf(session, this.program)) {
          return;
        }
        if (message.event === "stopped") {
          void this.follow(session);
        } else if (message.command === "restart" && message.success) {
          void this.show(this.program); // the text may be another one
        }
      },
    };
  }

  /** Goes to the present stop, once the page is there. */
  private begin(): void {
    const session = vscode.debug.activeDebugSession;
    if (session && this.program && isOf(session, this.program)) {
      void this.follow(session);
    }
  }

  private async follow(session: vscode.DebugSession): Promise<void> {
    try {
      const answer = await session.customRequest("evaluate", { expression: "time" });
      void this.panel?.webview.postMessage({ time: Number(answer.result) });
    } catch {
      // the program runs
    }
  }
}

function isOf(session: vscode.DebugSession, program: vscode.Uri): boolean {
  return session.type === "motionlang" && session.configuration.program === program.fsPath;
}

function options(configuration: vscode.DebugConfiguration): string[] {
  const words: string[] = [];
  for (const name of OPTIONS) {
    for (const value of [configuration[name] ?? []].flat()) {
      words.push(`--${name}`, String(value));
    }
  }
  for (const [name, value] of Object.entries(configuration.set ?? {})) {
    words.push("--set", `${name}=${value}`);
  }
  return words;
}
