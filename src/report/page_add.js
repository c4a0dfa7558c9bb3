'use strict';
/* page_add.js -- what the scripts of all pages take. */
function add(parent, tag, text, more) {
  const e = document.createElement(tag);
  if (text !== undefined && text !== null) e.textContent = text;
  Object.assign(e, more);
  parent.append(e);
  return e;
}
const short = x => typeof x !== 'number' ? String(x) :
  x !== 0 && (Math.abs(x) < 1e-3 || Math.abs(x) >= 1e6) ? x.toExponential(4).replace(/\.?0*e/, 'e') :
  String(+x.toPrecision(5));
const percent = x => +(100 * x).toPrecision(3) + ' %';
const finite = x => typeof x === 'number' && isFinite(x);
