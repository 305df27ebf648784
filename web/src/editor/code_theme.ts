// Looks of the editor. It lives in a shadow root, so that its styles need no exception from the content security policy;
// the tokens of the page reach it as custom properties.
import { EditorView } from '@codemirror/view';

const focus = { outline: '2px solid var(--focus)', outlineOffset: '-2px' };

export const codeTheme = EditorView.theme({
  '&': { height: '100%', color: 'var(--ink)', backgroundColor: 'var(--raised)', fontSize: 'var(--text)' },
  '&.cm-focused': focus,
  '.cm-scroller': { fontFamily: 'var(--mono)', lineHeight: '20px', overflowY: 'scroll' },
  // All of its height is for whole lines.
  '.cm-content': { caretColor: 'var(--ink)', paddingTop: '0' },
  '.cm-cursor': { borderLeftColor: 'var(--ink)', borderLeftWidth: '2px' },
  '.cm-gutters': { backgroundColor: 'var(--plate)', color: 'var(--ink-soft)', borderRight: '1px solid var(--line)' },
  '.cm-gutters-after': { borderRight: '0', borderLeft: '1px solid var(--line-strong)' },
  '.cm-activeLine, .cm-activeLineGutter': { backgroundColor: 'color-mix(in srgb, var(--sunken) 45%, transparent)' },
  '.cm-selectionBackground, &.cm-focused .cm-selectionBackground': { backgroundColor: 'var(--accent-soft) !important' },
  '.cm-matchingBracket': { backgroundColor: 'var(--accent-soft)', outline: '1px solid var(--accent)' },
  '.cm-shown-operand': { color: 'var(--code-operand)', borderBottom: '1px dotted var(--line-strong)' },

  '.cm-operand-value': {
    marginLeft: '1ch',
    padding: '0 4px',
    backgroundColor: 'var(--accent-soft)',
    color: 'var(--ink)',
    borderRadius: 'var(--radius)',
    fontWeight: '600',
  },

  '.cm-breakpoint-gutter': { width: '32px', cursor: 'pointer' },
  '.cm-breakpoint-gutter .cm-gutterElement': { position: 'relative', paddingLeft: '4px' },
  '.cm-breakpoint-gutter .cm-gutterElement:hover': { backgroundColor: 'var(--sunken)' },
  '.cm-point-mark': { color: 'var(--danger)' },
  '.cm-halt-mark': { position: 'absolute', left: '16px', color: 'var(--warning)' },
  '.cm-halt-line': {
    backgroundColor: 'var(--warning-soft)',
    boxShadow: 'inset 0 1px var(--warning), inset 0 -1px var(--warning)',
  },

  '.cm-failed-mark': { position: 'absolute', left: '16px', color: 'var(--danger)' },
  '.cm-failed-line': {
    backgroundColor: 'var(--danger-soft)',
    boxShadow: 'inset 0 1px var(--danger), inset 0 -1px var(--danger)',
  },

  '.cm-status-head': {
    display: 'flex',
    justifyContent: 'flex-end',
    backgroundColor: 'var(--plate)',
    color: 'var(--ink-soft)',
    borderBottom: '1px solid var(--line-strong)',
    fontFamily: 'var(--mono)',
    lineHeight: '20px',
  },
  '.cm-status-row': { display: 'flex', gap: '1ch', padding: '0 var(--s2)' },
  '.cm-status-cell': { display: 'inline-block', textAlign: 'right', whiteSpace: 'pre', overflow: 'hidden' },
  '.cm-gutters-after .cm-status-cell': { color: 'var(--ink)' },
  '.cm-gutters-after .cm-status-vke.cm-status-one, .cm-gutters-after .cm-status-sta.cm-status-one': {
    color: 'var(--on)',
    fontWeight: '700',
  },

  '.cm-collapsedLines': {
    background: 'var(--plate) !important',
    color: 'var(--ink-soft) !important',
    paddingLeft: '1ch',
  },
  '.cm-collapsedLines:before, .cm-collapsedLines:after': { content: '"⋯" !important' },

  '.cm-panels': { backgroundColor: 'var(--plate)', color: 'var(--ink)' },
  '.cm-panels-bottom': { borderTop: '1px solid var(--line-strong)' },
  // A finger needs room: the row of the page is higher then.
  '.cm-panel button, .cm-panel .cm-textfield': { minHeight: 'var(--row)' },
  '.cm-panel label': { display: 'inline-flex', alignItems: 'center', minHeight: 'var(--row)' },
  '.cm-panel input[type=checkbox]': { width: 'calc(var(--row) / 2)', height: 'calc(var(--row) / 2)' },
  '.cm-panel [name=close]': { minWidth: 'var(--row)' },
  '.cm-panel:has([name=close])': { paddingRight: 'calc(var(--row) + 8px)' },
  '.cm-panel input, .cm-panel button': { fontFamily: 'var(--sans)', fontSize: 'var(--text)' },
  '.cm-textfield': { backgroundColor: 'var(--raised)', border: '1px solid var(--line-strong)' },
  '.cm-button': { backgroundImage: 'none', backgroundColor: 'var(--raised)', border: '1px solid var(--line-strong)' },

  '.cm-tooltip': {
    backgroundColor: 'var(--raised)',
    color: 'var(--ink)',
    border: '1px solid var(--line-strong)',
    borderRadius: 'var(--radius)',
  },
  '.cm-tooltip.cm-tooltip-autocomplete > ul': { fontFamily: 'var(--mono)', maxHeight: '240px' },
  '.cm-tooltip-autocomplete ul li': { padding: '2px var(--s2) !important' },
  '.cm-tooltip.cm-tooltip-autocomplete > ul > li[aria-selected]': {
    backgroundColor: 'var(--accent)',
    color: 'var(--accent-ink)',
  },
  '.cm-completionDetail': { fontStyle: 'normal', color: 'var(--ink-soft)', marginLeft: '2ch' },
  'li[aria-selected] .cm-completionDetail': { color: 'inherit' },
  '.cm-completionInfo': { fontFamily: 'var(--sans)', padding: 'var(--s2)' },
  '.cm-completionMatchedText': { textDecoration: 'none', fontWeight: '700' },

  '.cm-lintRange-error': {
    backgroundImage: 'none',
    textDecoration: 'underline wavy var(--danger) 1.5px',
    textUnderlineOffset: '3px',
  },
  '.cm-lintRange-warning': {
    backgroundImage: 'none',
    textDecoration: 'underline wavy var(--warning) 1.5px',
    textUnderlineOffset: '3px',
  },
  '.cm-diagnostic': {
    fontFamily: 'var(--sans)',
    padding: 'var(--s2) var(--s3)',
    borderLeft: '0',
    maxWidth: '480px',
    whiteSpace: 'normal',
  },
  '.cm-operand-tooltip': { padding: 'var(--s1) var(--s3)', fontFamily: 'var(--mono)', whiteSpace: 'pre-wrap' },
  '.cm-problem-code': { color: 'var(--ink-soft)', fontFamily: 'var(--mono)', fontSize: 'var(--text-small)' },
});
