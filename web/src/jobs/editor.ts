import { defaultKeymap, history, historyKeymap, indentWithTab } from '@codemirror/commands';
import { defaultHighlightStyle, HighlightStyle, StreamLanguage, syntaxHighlighting } from '@codemirror/language';
import { toml } from '@codemirror/legacy-modes/mode/toml';
import { Compartment, EditorState, StateEffect, StateField, type Extension } from '@codemirror/state';
import { Decoration, EditorView, highlightActiveLine, keymap, lineNumbers, type DecorationSet } from '@codemirror/view';
import { tags } from '@lezer/highlight';

const markLine = StateEffect.define<number | null>();
const marked = StateField.define<DecorationSet>({
  create: () => Decoration.none,
  update(set, transaction) {
    for (const effect of transaction.effects) {
      if (!effect.is(markLine)) continue;
      const line = effect.value;
      if (line === null || line < 1 || line > transaction.state.doc.lines) return Decoration.none;
      return Decoration.set([Decoration.line({ class: 'wrong' }).range(transaction.state.doc.line(line).from)]);
    }
    return set.map(transaction.changes);
  },
  provide: (field) => EditorView.decorations.from(field),
});

const lookOf = (dark: boolean): Extension => [
  EditorView.theme(
    {
      '&': { height: '100%', fontSize: '13px' },
      '.cm-scroller': { overflow: 'auto', fontFamily: 'ui-monospace, monospace' },
      '.cm-gutters': dark ? { background: '#1f2429', color: '#aab3bc' } : { background: '#eceef0', color: '#4c545c' },
      '.wrong': { background: dark ? '#47191c' : '#fbe3e4' },
    },
    { dark },
  ),
  syntaxHighlighting(dark ? darkHighlight : defaultHighlightStyle),
];

const darkHighlight = HighlightStyle.define([
  { tag: tags.comment, color: '#9aa5b1' },
  { tag: tags.string, color: '#e0a866' },
  { tag: [tags.number, tags.bool, tags.atom], color: '#8ad0a4' },
  { tag: [tags.propertyName, tags.definition(tags.propertyName)], color: '#8db8e8' },
]);

/**
 * The editor of texts, or what shows them where `changed` is none. It lives in a shadow root, since there CodeMirror's styles are adopted sheets, which the server's
 * content policy allows; as `style` elements of the page they would be refused.
 */
export class Editor {
  private readonly view: EditorView;
  private readonly look = new Compartment();

  constructor(host: HTMLElement, label: string, text: string, changed: ((text: string) => void) | null) {
    const root = host.shadowRoot ?? host.attachShadow({ mode: 'open' });
    const parent = document.createElement('div');
    parent.style.height = '100%';
    root.replaceChildren(parent);
    this.view = new EditorView({
      parent,
      root,
      state: EditorState.create({
        doc: text,
        extensions: [
          lineNumbers(),
          history(),
          highlightActiveLine(),
          StreamLanguage.define(toml),
          marked,
          this.look.of(lookOf(false)),
          keymap.of([...defaultKeymap, ...historyKeymap, indentWithTab]),
          EditorView.contentAttributes.of({ 'aria-label': label }),
          EditorState.readOnly.of(changed === null),
          EditorView.updateListener.of((update) => {
            if (update.docChanged) changed?.(update.state.doc.toString());
          }),
        ],
      }),
    });
    // What scrolls can be reached by keyboard.
    this.view.scrollDOM.tabIndex = 0;
  }

  set(text: string): void {
    const { doc } = this.view.state;
    if (doc.toString() === text) return;
    this.view.dispatch({ changes: { from: 0, to: doc.length, insert: text } });
  }

  dark(dark: boolean): void {
    this.view.dispatch({ effects: this.look.reconfigure(lookOf(dark)) });
  }

  mark(line: number | null): void {
    this.view.dispatch({ effects: markLine.of(line) });
  }

  /** Puts the cursor to the begin of a line, which is then seen. */
  show(line: number): void {
    const { doc } = this.view.state;
    const { from } = doc.line(Math.min(Math.max(line, 1), doc.lines));
    this.view.dispatch({ selection: { anchor: from }, effects: EditorView.scrollIntoView(from, { y: 'center' }) });
    this.view.focus();
  }

  end(): void {
    this.view.destroy();
  }
}
