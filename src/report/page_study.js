/* page_study.js -- a study: error against cost, and the variant for a wished error. What
 * src/study/html.c has put into hidden elements is shown as text, whatever it is. */
const number = t => t === undefined ? NaN : +t;
const near = (x, digits) => finite(x) ? String(+x.toPrecision(digits)).replace('e+', 'e') : '';
function hidden(kind) {
  return [...document.querySelectorAll('i.' + kind)].map(e => ({ ...e.dataset, e }));
}
const study = document.getElementById('study').dataset, measures = hidden('measure');
const variants = hidden('variant').map((d, i) => ({ ...d, i, cost: number(d.cost), seconds: number(d.seconds),
  scatter: number(d.scatter) || 0, ended: d.ended === '1', runs: [...d.e.querySelectorAll('u')].map(u => ({ ...u.dataset })),
  of: [...d.e.querySelectorAll('b')].map(b => Object.fromEntries(['value', 'truth', 'error', 'uncertainty', 'order']
    .map(k => [k, number(b.dataset[k])]))) }));
const standing = variants.find(v => v.standing), last = variants[variants.length - 1];
const unit = study.processor ? ' s' : '', of = v => v.of[now.m];
const now = { m: 0, y: 'error', x: 'cost', target: 1, chosen: null };

/* --- the cheapest for a wished error, as src/study/report.c finds it ------------------- */

const same = (a, b) => Math.abs(a.cost - b.cost) <= 2 * Math.hypot(a.scatter, b.scatter);
const least = (list, f) => list.reduce((best, v) => best === null || f(v) < f(best) ? v : best, null);
function cheapest(limit) {
  let within = variants.filter(v => v.ended && finite(v.cost) && of(v).error + 2 * of(v).uncertainty <= limit);
  const first = least(within, v => v.cost);
  within = within.filter(v => same(v, first));
  const best = within.includes(standing) ? standing : least(within, v => of(v).error);
  return best && standing && measures[now.m].finest && !finite(of(standing).error) &&
    (standing.cost <= best.cost || same(standing, best)) ? standing : best;
}
function differs(v) {
  const f = of(v), word = measures[now.m].error;
  if (v.reason) return v.reason;
  if (!v.ended) return 'has not ended';
  if (measures[now.m].finest && v === last && !(f.error === 0)) return 'the reference' + spread(f, ', its own standard error ');
  return finite(f.error) ? word + ' ' + near(100 * f.error, 3) + ' %' + spread(f, ' ± ') : 'no ' + word + ' is known';
}
const spread = (f, before) => f.uncertainty > 0 ? before + near(100 * f.uncertainty, 3) + ' %' : '';

/* --- the picture ------------------------------------------------------------------------ */

const shades = ['#2f7fc1', '#d1711a', '#3d9a4d', '#9a5ac0', '#8a8f98', '#b8860b', '#2a9a9a', '#c04080'];
const lines = [...new Set(variants.map(v => v.line))];
const shape = (i, x, y, r) => [`M${x - r},${y}a${r},${r} 0 1 0 ${2 * r},0a${r},${r} 0 1 0 ${-2 * r},0`,
  `M${x - r},${y - r}h${2 * r}v${2 * r}h${-2 * r}z`, `M${x},${y - 1.2 * r}l${1.2 * r},${2.1 * r}h${-2.4 * r}z`,
  `M${x},${y - 1.3 * r}l${1.3 * r},${1.3 * r}l${-1.3 * r},${1.3 * r}l${-1.3 * r},${-1.3 * r}z`][i % 4];
function draw(parent, tag, more, text) {
  const e = document.createElementNS('http://www.w3.org/2000/svg', tag);
  for (const k in more) e.setAttribute(k, more[k]);
  if (text !== undefined) e.textContent = text;
  parent.append(e);
  return e;
}
/* An axis: places of numbers from a to b [px], and its marks. */
function axis(low, high, a, b, log) {
  const f = log ? Math.log10 : x => x, [l, h] = [f(low), f(high)], marks = [];
  const step = 10 ** Math.floor(f === Math.log10 ? 0 : Math.log10((high - low) / 3 || 1));
  if (log)
    for (let d = Math.floor(l); d <= h; d++)
      for (const k of h - l > 3 ? [1] : h - l > 1 ? [1, 2, 5] : [1, 1.5, 2, 3, 5, 7]) marks.push(k * 10 ** d);
  else
    for (let x = Math.ceil(low / step); x * step <= high; x++) marks.push(x * step);
  const thin = Math.ceil(marks.filter(x => x >= low && x <= high).length / (Math.abs(b - a) / 48));
  const put = x => a + (b - a) * (f(x) - l) / (h - l || 1);
  return { put, marks: marks.filter(x => x >= low && x <= high).filter((x, i) => i % thin === 0) };
}
function range(values, log) {
  const known = values.filter(x => finite(x) && (!log || x > 0));
  if (!known.length) return [1, 10];
  const low = Math.min(...known), high = Math.max(...known), more = (high - low || Math.abs(high) || 1) * 0.15;
  return log ? [low / 1.3, high * 1.3] : [low - more, high + more];
}
const x_of = v => v[now.x];
const y_of = v => now.y === 'value' ? of(v).value : 100 * of(v).error;
const half = v => 2 * of(v).uncertainty * (now.y === 'value' ? Math.abs(finite(of(v).truth) ? of(v).truth : of(v).value) : 100);
const shown = () => variants.filter(v => v.ended && x_of(v) > 0 && finite(of(v).value));
function picture(svg) {
  const w = svg.clientWidth || 600, h = Math.max(260, Math.min(430, 0.7 * w)), all = shown(), m = measures[now.m];
  const log = now.y === 'error', right = w - 14, bottom = h - 44, left = 62;
  svg.textContent = '';
  svg.setAttribute('viewBox', `0 0 ${w} ${h}`);
  svg.style.height = h + 'px';
  const truth = all.map(v => of(v).truth).find(finite), own = m.finest && last.ended ? of(last).uncertainty : 0;
  const goal = log ? [now.target] : finite(truth) ? [truth * (1 - now.target / 100), truth * (1 + now.target / 100)] : [];
  const X = axis(...range(all.map(x_of), true), left, right, true);
  const ends = all.flatMap(v => log ? [y_of(v), y_of(v) + half(v)] : [y_of(v) - half(v), y_of(v) + half(v)]);
  const Y = axis(...range([...ends, ...goal, ...(log ? [] : [truth])], log), bottom - 14, 16, log);
  const y_at = v => log && !(y_of(v) > 0) ? bottom : Y.put(y_of(v)), clip = y => Math.max(8, Math.min(bottom, y));
  if (own > 0) {
    const top = clip(log ? Y.put(200 * own) : Y.put(truth + 2 * own * Math.abs(truth)));
    const foot = log ? bottom : clip(Y.put(truth - 2 * own * Math.abs(truth)));
    draw(svg, 'rect', { class: 'band', x: left, width: right - left, y: top, height: Math.max(1, foot - top) });
  }
  for (const x of X.marks) {
    draw(svg, 'path', { class: 'grid', d: `M${X.put(x)},10V${bottom}` });
    draw(svg, 'text', { x: X.put(x), y: bottom + 16, 'text-anchor': 'middle' }, near(x, 3));
  }
  for (const y of Y.marks) {
    draw(svg, 'path', { class: 'grid', d: `M${left},${Y.put(y)}H${right}` });
    draw(svg, 'text', { x: left - 6, y: Y.put(y) + 4, 'text-anchor': 'end' }, near(y, 4));
  }
  for (const g of goal) draw(svg, 'path', { class: 'goal', d: `M${left},${clip(Y.put(g))}H${right}` });
  if (!log && finite(truth)) draw(svg, 'path', { class: 'truth', d: `M${left},${clip(Y.put(truth))}H${right}` });
  draw(svg, 'text', { x: (left + right) / 2, y: h - 8, 'text-anchor': 'middle' }, now.x === 'cost' ? study.cost : 'processor time of a run [s]');
  draw(svg, 'text', { transform: `translate(14 ${bottom / 2}) rotate(-90)`, 'text-anchor': 'middle' }, log ? m.error + ' [%]' : ['value', m.unit].join(' '));
  lines.forEach((line, i) => {
    const on = all.filter(v => v.line === line), colour = shades[i % 8];
    if (study.along) draw(svg, 'path', { class: 'line', stroke: colour, d: 'M' + on.map(v => X.put(x_of(v)) + ',' + y_at(v)).join('L') });
    for (const v of on) {
      const x = X.put(x_of(v)), y = y_at(v);
      if (half(v) > 0 && y < bottom)
        draw(svg, 'path', { stroke: colour, d: `M${x},${clip(Y.put(y_of(v) + half(v)))}V${clip(!log || y_of(v) > half(v) ? Y.put(y_of(v) - half(v)) : bottom)}` });
      const g = draw(svg, 'g', { class: 'point' + (v === now.chosen ? ' chosen' : ''), tabindex: 0, role: 'button',
        'data-label': v.label, 'aria-label': v.words + ', ' + near(x_of(v), 4) + ', ' + differs(v) });
      draw(g, 'title', {}, v.words + ': ' + differs(v));
      draw(g, 'circle', { cx: x, cy: y, r: 14, class: 'reach' });
      draw(g, 'path', { d: shape(i, x, y, v === now.chosen ? 8 : 5.5), fill: y === bottom ? 'none' : colour, stroke: colour, 'stroke-width': 2 });
      g.onclick = () => choose_variant(v);
      g.onkeydown = e => {
        const step = { ArrowRight: 1, ArrowDown: 1, ArrowLeft: -1, ArrowUp: -1 }[e.key];
        const order = shown().sort((a, b) => x_of(a) - x_of(b)), next = order[order.indexOf(v) + step];
        if (e.key === 'Enter' || e.key === ' ' || next) { e.preventDefault(); choose_variant(next || v, true); }
      };
    }
  });
}

/* --- the page --------------------------------------------------------------------------- */

const main = document.querySelector('main');
document.title = study.title + ' – Winnow';
add(main, 'h1', study.title);
add(main, 'p', study.case + ', ' + study.ended + ' of ' + study.runs + ' runs have ended' +
  (study.seeds > 1 ? ', each variant with ' + study.seeds + ' seeds' : ''), { className: 'note' });
if (study.ended !== study.runs)
  add(main, 'p', 'The study was interrupted. The same command goes on where it stopped.', { className: 'warn' });
const tools = add(main, 'div', null, { className: 'tools' });
function choice(label, options, key, keep) {
  const box = add(tools, 'label', label + ' '), s = add(box, 'select');
  for (const [value, text] of options) add(s, 'option', text, { value });
  s.onchange = () => { now[key] = keep(s.value); show(); };
}
choice('Measure', measures.map((m, i) => [i, m.words]), 'm', Number);
choice('Show', [['error', 'error or difference'], ['value', 'value']], 'y', String);
if (!study.processor) choice('against', [['cost', study.cost], ['seconds', 'processor time']], 'x', String);
const wished = add(add(tools, 'label', 'Wished error [%] '), 'input', null,
  { type: 'number', min: 0, step: 'any', value: now.target });
wished.oninput = () => { if (+wished.value > 0) { now.target = +wished.value; show(); } };
const against = add(main, 'p', null, { id: 'against' }), answer = add(main, 'p', null, { id: 'answer' });
answer.setAttribute('aria-live', 'polite');
const two = add(main, 'div', null, { className: 'two' }), left = add(two, 'div'), card = add(two, 'div', null, { className: 'card' });
const svg = draw(left, 'svg', { class: 'study', role: 'group', 'aria-label': 'a point a variant; arrow keys go from one to the next' });
const legend = add(left, 'div', null, { className: 'note' });
const box = add(main, 'div', null, { className: 'wide' }), keys = hidden('choice');

function copy(text, button) {
  const done = () => { button.textContent = 'Copied'; }, select = () => {
    getSelection().selectAllChildren(card.querySelector('code'));
    if (document.execCommand('copy')) done();
  };
  if (navigator.clipboard) navigator.clipboard.writeText(text).then(done, select);
  else select();
}
function details() {
  const v = now.chosen;
  card.textContent = '';
  card.className = 'card' + (v && v.reason ? ' bad' : '');
  if (!v) return void add(card, 'p', 'Choose a point or a row: here stand its command and its values.');
  add(card, 'h3', v.words + (v.standing ? ', the case as it stands' : ''));
  const line = add(card, 'p'), command = add(line, 'code', v.command, { className: 'command' });
  const button = add(line, 'button', 'Copy');
  button.onclick = () => copy(command.textContent, button);
  if (v.reason) add(card, 'p', v.reason, { className: 'warn' });
  const body = add(card, 'table'), row = (...cells) => {
    const r = add(body, 'tr');
    cells.forEach((c, i) => add(r, 'td', c, { className: i === 1 ? 'number' : '' }));
  };
  row('processor time [s]', near(v.seconds, 4));
  if (!study.processor) row(study.cost, near(v.cost, 4));
  const kept = now.m;
  measures.forEach((m, i) => { now.m = i; row([m.words, m.unit].join(' '), near(of(v).value, 5), m.none ? '' : differs(v)); });
  now.m = kept;
  for (const r of v.runs) {
    const p = add(card, 'p', null, { className: 'note' });
    if (r.report) add(p, 'a', r.run, { href: 'runs/' + encodeURIComponent(r.run) + '/report.html' });
    else add(p, 'span', r.code < 0 ? r.run + ' has not ended' : 'its page: winnow report ' + r.folder);
  }
}
function choose_variant(v, focus) {
  now.chosen = v;
  show();
  if (focus) [...svg.querySelectorAll('.point')].find(g => g.dataset.label === v.label).focus();
}
function explain() {
  legend.textContent = '';
  keys.forEach(k => add(legend, 'div', k.words + ': ' + k.e.textContent));
  if (lines.length > 1) {
    const list = add(legend, 'div', null, { className: 'tools' });
    lines.forEach((line, i) => {
      const s = draw(add(list, 'span'), 'svg', { width: 18, height: 14 });
      draw(s, 'path', { d: shape(i, 9, 7, 5), fill: shades[i % 8] });
      s.parentNode.append(' ' + line);
    });
  }
  if (study.along) add(legend, 'div', 'Along a line: ' + study.along + '.');
  if (measures[now.m].finest && last.ended && of(last).uncertainty > 0)
    add(legend, 'div', 'The band: two standard errors of the reference. Bars: two of each variant.');
  if (now.y === 'error' && shown().some(v => !(y_of(v) > 0))) add(legend, 'div', 'Hollow, at the bottom: the reference, or no ' + measures[now.m].error + '.');
}
function rows() {
  box.textContent = '';
  const body = add(box, 'table'), head = add(body, 'tr'), m = measures[now.m];
  for (const h of ['variant', 'processor time [s]', ...(study.processor ? [] : [study.cost]), ['value', m.unit].join(' '), m.error + ' [%]', 'order']) add(head, 'th', h);
  for (const v of variants) {
    const row = add(body, 'tr', null, { className: v === now.chosen ? 'chosen' : '' });
    add(add(row, 'td'), 'button', v.words || v.label, { onclick: () => choose_variant(v) }).dataset.label = v.label;
    const put = (x, digits) => add(row, 'td', near(x, digits), { className: 'number' });
    put(v.seconds, 4);
    if (!study.processor) put(v.cost, 4);
    put(of(v).value, 5);
    add(row, 'td', differs(v).replace(/^(error|difference) /, ''));
    put(of(v).order, 3);
  }
}
function show() {
  const m = measures[now.m], best = cheapest(now.target / 100);
  against.textContent = m.none ? m.words : m.words + ': ' + m.error + (m.finest ? ' from ' : ' against ') + m.reference +
    (m.finest ? ', the reference' + (last.ended ? spread(of(last), ', whose own standard error is ') : ', which has not come to its end') : '') + '.';
  answer.textContent = '';
  if (best) {
    add(answer, 'span', 'The cheapest within ' + near(now.target, 4) + ' %: ');
    add(answer, 'button', best.words || best.label, { onclick: () => choose_variant(best) }).dataset.best = best.label;
    add(answer, 'span', ', ' + near(best.cost, 3) + unit + ', ' + differs(best));
  } else answer.textContent = m.none ? '' : 'No variant is certainly within ' + near(now.target, 4) + ' %.';
  picture(svg);
  explain();
  details();
  rows();
}
window.addEventListener('resize', () => picture(svg));
show();
