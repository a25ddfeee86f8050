// Marks beside the lines of programs: what their runs reach, and what they do not.

import * as vscode from "vscode";

/** A line of `motionlang cover --format json`. */
interface Line {
  line: number;
  count: number;
  missed: string | null;
}

/** Returns the document of `motionlang cover FILE --format json`, or undefined if it has failed. */
export type Cover = (program: vscode.Uri) => Promise<string | undefined>;

export class CoverageMarks implements vscode.Disposable {
  private readonly reached = mark("#2e9e5b");
  private readonly partly = mark("#d9a514");
  private readonly missed = mark("#c8322b");
  private readonly lines = new Map<string, Line[]>();
  private readonly watched: vscode.Disposable;

  constructor(private readonly cover: Cover) {
    this.watched = vscode.Disposable.from(
      vscode.window.onDidChangeVisibleTextEditors((editors) => editors.forEach((each) => this.draw(each))),
      // The marks are those of the saved text.
      vscode.workspace.onDidChangeTextDocument((change) => this.forget(change.document)),
    );
  }

  /** Runs a program and marks its lines; again, it removes the marks. */
  async show(program: vscode.Uri): Promise<void> {
    const key = program.toString();
    if (this.lines.delete(key)) {
      this.drawAll(key);
      return;
    }
    const text = await this.cover(program);
    if (text !== undefined) {
      this.lines.set(key, (JSON.parse(text) as { lines: Line[] }).lines);
      this.drawAll(key);
    }
  }

  dispose(): void {
    vscode.Disposable.from(this.watched, this.reached, this.partly, this.missed).dispose();
  }

  private forget(document: vscode.TextDocument): void {
    if (this.lines.delete(document.uri.toString())) {
      this.drawAll(document.uri.toString());
    }
  }

  private drawAll(key: string): void {
    vscode.window.visibleTextEditors.filter((each) => each.document.uri.toString() === key).forEach((each) => this.draw(each));
  }

  private draw(editor: vscode.TextEditor): void {
    const lines = this.lines.get(editor.document.uri.toString()) ?? [];
    const marks = (wanted: (line: Line) => boolean): vscode.DecorationOptions[] =>
      lines.filter(wanted).map((each) => ({
        range: new vscode.Range(each.line - 1, 0, each.line - 1, 0),
        hoverMessage: each.missed ?? `reached ${each.count} time${each.count === 1 ? "" : "s"}`,
      }));
    editor.setDecorations(this.reached, marks((each) => each.count > 0 && each.missed === null));
    editor.setDecorations(this.partly, marks((each) => each.count > 0 && each.missed !== null));
    editor.setDecorations(this.missed, marks((each) => each.count === 0));
  }
}

/** Returns a bar in the gutter and in the overview. */
function mark(colour: string): vscode.TextEditorDecorationType {
  const bar = `<svg xmlns="http://www.w3.org/2000/svg" width="16" height="16"><rect x="11" width="4" height="16" fill="${colour}"/></svg>`;
  return vscode.window.createTextEditorDecorationType({
    isWholeLine: true,
    gutterIconPath: vscode.Uri.parse(`data:image/svg+xml;utf8,${encodeURIComponent(bar)}`),
    gutterIconSize: "contain",
    overviewRulerColor: colour,
    overviewRulerLane: vscode.OverviewRulerLane.Left,
  });
}
