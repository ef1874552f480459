// How the scene's controls look; made by CSSOM, since the page's policy lets no element bring styles of its own.

const RULES = `
.scene { --ink: #1d2329; --soft: #4d5863; --chip: rgba(255, 255, 255, 0.82); --line: #c6ccd3; --field: #ffffff;
  --sky: #f4f7fa; --earth: #e3e8ed; --strong: #005a8f;
  container-type: inline-size; display: flex; flex-direction: column; min-width: 0; min-height: 0; height: 100%;
  color: var(--ink);
  font: 13px/1.35 system-ui, sans-serif; }
@media (prefers-color-scheme: dark) { .scene { --ink: #e8ecf0; --soft: #b3bdc7; --chip: rgba(20, 25, 31, 0.8);
  --line: #46515c; --field: #1b2127; --sky: #1b222a; --earth: #12171d; --strong: #7cc4f2; } }
.scene-bar { display: flex; flex-wrap: wrap; align-items: center; gap: 4px 12px; padding: 6px 8px; }
.scene-bar label { display: inline-flex; align-items: center; gap: 6px; white-space: nowrap; }
.scene-bar select, .scene-bar button { font: inherit; color: inherit; background: var(--field);
  border: 1px solid var(--line); border-radius: 5px; padding: 3px 8px; min-height: 28px; cursor: pointer; }
.menu-panel { position: fixed; inset: auto; margin: 0; width: max-content; max-width: calc(100vw - 16px);
  max-height: calc(100vh - 16px); overflow: auto; padding: 8px 10px; color: inherit; background: var(--field);
  border: 1px solid var(--line); border-radius: 6px; box-shadow: 0 4px 14px rgba(0, 0, 0, 0.2); }
.menu-panel:popover-open { display: grid; gap: 4px; }
.menu-panel label { display: flex; align-items: center; gap: 6px; }
.scene-bar select { field-sizing: content; max-width: 13em; text-overflow: ellipsis; }
.scene-bar .menu-button::after { content: " ▾"; white-space: pre; }
.scene-bar input[type=range] { width: 104px; accent-color: var(--strong); }
.scene-bar output { min-width: 2.6em; font-variant-numeric: tabular-nums; }
.scene :focus-visible { outline: 2px solid var(--strong); outline-offset: 1px; }
.scene-view { position: relative; flex: 1 1 auto; min-height: 220px; overflow: hidden; border-radius: 6px;
  background: linear-gradient(var(--sky), var(--earth)); }
.scene-view canvas { position: absolute; inset: 0; width: 100%; height: 100%; display: block; touch-action: none; }
.scene-view .scene-overlay { pointer-events: none; }
.scene-axes { flex: 1 0 100%; max-width: 88px; height: 96px; }
.scene-note { box-sizing: border-box; position: absolute; pointer-events: none; background: var(--chip);
  border-radius: 5px; padding: 4px 8px; }
.scene-note[hidden] { display: none; }
.scene-legend { top: 8px; left: 8px; display: flex; flex-wrap: wrap; gap: 2px 12px;
  max-width: min(46%, 24em); }
.scene-legend span { display: flex; align-items: center; gap: 6px; }
.scene-legend i { flex: none; width: 16px; height: 8px; border-radius: 2px; }
.scene-scale { top: 8px; right: 8px; display: grid; gap: 2px; max-width: 46%; min-width: 11em; }
.scene-scale b { font-weight: 600; }
.scene-scale ol { list-style: none; margin: 0; padding: 0; display: flex; justify-content: space-between; gap: 6px;
  font-variant-numeric: tabular-nums; line-height: 1.2; }
.scene-scale i { height: 8px; border-radius: 2px; }
.scene-foot { position: absolute; inset: auto 8px 8px; display: flex; align-items: flex-end; gap: 8px;
  pointer-events: none; }
.scene-foot .scene-note { position: static; }
.scene-below { display: flex; flex-wrap: wrap; align-items: flex-end; gap: 4px; min-width: 0;
  color: var(--soft); }
.scene-factor { flex: none; margin-left: auto; font-weight: 600; }
.scene-message { position: absolute; inset: 0; display: grid; place-content: center; padding: 2em; text-align: center; }
@container (max-width: 760px) {
  .scene-bar { gap: 4px 8px; }
  .scene-bar label { gap: 4px; }
  .scene-bar select { max-width: 18.5em; padding: 3px 4px; }
  .scene-bar .scene-name { display: none; }
}
@container (max-width: 520px) {
  .scene-bar { padding: 4px 6px; gap: 4px 6px; }
  .scene-bar select { flex: 1 1 5em; min-width: 0; }
  .scene-bar label:has(> select) { flex: 1 1 5em; min-width: 0; }
  .scene-bar > .menu { order: 1; }
  .scene-bar > .scene-factor-row { order: 2; flex: 1 1 60%; }
  .scene-bar > button { order: 3; }
  .scene-bar input[type=range] { flex: 1 1 64px; min-width: 64px; }
  .scene-view { min-height: 160px; }
  .scene-note { font-size: 11px; padding: 2px 5px; }
  .scene-legend { max-width: calc(58% - 12px); gap: 1px 8px; }
  .scene-legend i { width: 10px; }
  .scene-scale { max-width: calc(42% - 12px); min-width: 8em; }
  .scene-foot { flex-wrap: wrap; gap: 4px; }
  .scene-scale li:nth-child(even) { display: none; }
}
@media (pointer: coarse), (max-width: 40rem) {
  .scene-bar select, .scene-bar button { min-height: 40px; min-width: 40px; }
  .menu-panel label { min-height: 40px; }
  .menu-panel input { width: 20px; height: 20px; }
}
@media print { .scene-bar { display: none; } }
`;

let sheet: CSSStyleSheet | null = null;

/** Put the rules into the document, once. */
export function useStyle(): void {
  if (sheet !== null) return;
  sheet = new CSSStyleSheet();
  sheet.replaceSync(RULES);
  document.adoptedStyleSheets = [...document.adoptedStyleSheets, sheet];
}
