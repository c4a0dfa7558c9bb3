/* page.js -- shows what the hidden elements of the page hold. All that comes from a
 * folder is put in by textContent, so that it stays text. */

/* --- what was computed -------------------------------------------------------------- */

function table(text, rows) {
  const lines = text.split('\n').filter(l => l !== '');
  if (!lines.length) return null;
  return { names: lines[0].split(','), all: +rows,
           rows: lines.slice(1).map(l => l.split(',').map(Number)) };
}

function json(text) {
  try {
    const value = JSON.parse(text);
    return value !== null && typeof value === 'object' ? value : {};
  } catch (wrong) { return {}; }
}

/* One array of one state. */
function numbers(e) {
  const d = e.dataset, low = +d.low, high = +d.high, list = t => (t || '').split(' ').map(Number);
  const bytes = atob(e.textContent), value = new Float32Array(bytes.length >> 1);
  for (let i = 0; i < value.length; i++) {
    const w = bytes.charCodeAt(2 * i) | bytes.charCodeAt(2 * i + 1) << 8;
    value[i] = w === 65535 ? NaN : low + w / 65534 * (high - low);
  }
  e.remove();
  return { series: d.series, name: d.array, time: +d.time, low, high, value,
           axis: +d.axis, at: +d.at, size: list(d.size), box: list(d.box) };
}

function vector(text, key) {
  const m = new RegExp('(?:^|[\\s{;])' + key + '\\s*=\\s*\\[([^\\]]*)\\]').exec(text);
  const v = m && m[1].split(',').map(Number);
  return v && v.length === 3 && v.every(isFinite) ? v : null;
}

function read(section, i) {
  const file = name => (section.querySelector('pre[data-name="' + name + '"]') || {}).textContent || '';
  const history = section.querySelector('pre[data-name="history.csv"]');
  const run = { i, folder: section.dataset.folder, process: +section.dataset.process,
                text: file('case.cfg'),
                estimates: new Map(file('estimates').split('\n').map(l => l.split('\t')).map(([k, share, says]) =>
                  [k, { share: parseFloat(share), says }])), summary: json(file('summary.json')),
                history: history && table(history.textContent, history.dataset.rows),
                profiles: [...section.querySelectorAll('pre[data-name^="profiles/"]')].map(e =>
                  ({ name: e.dataset.name.slice(9, -4), ...table(e.textContent) })),
                left: [...section.querySelectorAll('pre[data-name="left"]')].map(e => e.textContent.trim()),
                arrays: [...section.querySelectorAll('i[data-array]')].map(numbers) };
  const picture = section.querySelector('i[data-picture]');
  run.picture = picture && picture.textContent;
  const title = /^\s*title\s*=\s*"((?:[^"\\]|\\.)*)"/m.exec(run.text);
  run.title = title ? title[1].replace(/\\(.)/g, '$1') : run.summary.case || run.folder;
  const g = vector(run.text, 'gravity');
  run.up = g && g.some(x => x) ? g.map(x => -x) : [0, 1, 0];
  run.box = vector(run.text, 'size');
  run.times = [...new Set(run.arrays.map(a => a.time))].sort((a, b) => a - b);
  section.remove();
  return run;
}

/* What a number of "worst" must not exceed, and what it means if it does. */
const limits = {
  mass_residual: [1e-4, 'fluid that a cell gains or loses without a flux, of what flows through it'],
  momentum_residual: [1e-6, 'change of the momentum of the fluid without a force'],
  exchange_residual: [1e-9, 'impulse on the fluid plus impulse charged to the particles'],
  cfl: [1, 'cells that the fluid crosses in one step'],
  overlap: [0.1, 'largest overlap of two particles, in diameters'],
  steps_with_capped_cells: [0, 'steps in which a cell had more solid than the model allows'],
};
const over = (name, x) => name in limits && !(x <= limits[name][0]);

function warnings(run) {
  const worst = run.summary.worst || {};
  return Object.keys(worst).filter(k => over(k, worst[k])).map(k =>
    k + ' = ' + short(worst[k]) + ', more than ' + limits[k][0] + ': ' + limits[k][1]);
}

function ended(run) {
  const s = run.summary;
  if (run.process) return ['is being computed (process ' + run.process + ')', false];
  if (!('exit_reason' in s)) return ['there is no summary of it', true];
  if (s.exit_code === null) return ['was killed while it was being computed', true];
  return [s.exit_code === 0 ? 'done' : 'exit code ' + s.exit_code + ': ' + s.exit_reason, s.exit_code !== 0];
}

function verdict(parent, run) {
  const [words, bad] = ended(run), warned = warnings(run), s = run.summary, h = s.second_half || {};
  const card = add(parent, 'div', null, { className: 'card' + (bad || warned.length ? ' bad' : '') });
  add(card, 'h1', run.title);
  add(card, 'p', run.folder, { className: 'note' });
  add(card, 'p', 'The run: ' + words, { className: bad ? 'warn' : '' });
  if (finite(s.simulated_seconds))
    add(card, 'p', short(s.simulated_seconds) + ' s in ' + s.steps + ' steps' +
        (s.cells ? ', ' + s.cells + ' cells' : '') + (s.particles ? ', ' + s.particles + ' particles' : ''));
  if (finite(h.mean_pressure_drop) && h.mean_pressure_drop !== 0) {
    const weight = finite(h.buoyant_weight) ? h.buoyant_weight : null;
    add(card, 'p', 'Pressure drop ' + short(h.mean_pressure_drop) +
        (finite(h.mean_pressure_drop_error) ? ' ± ' + short(h.mean_pressure_drop_error) : '') +
        ' Pa, mean of the second half' + (weight ? '; the buoyant weight of the bed is ' + short(weight) +
        ' Pa (' + percent(h.mean_pressure_drop / weight - 1) + ')' : ''), { className: 'balance' });
  }
  for (const w of warned) add(card, 'p', w, { className: 'warn' });
  if (s.worst && !warned.length) add(card, 'p', 'All residuals are within their limits.');
  for (const l of run.left) add(card, 'p', 'Left out: ' + l + '.', { className: 'note' });
}

/* --- colours ------------------------------------------------------------------------ */

const stops = [[68, 1, 84], [59, 82, 139], [33, 145, 140], [94, 201, 98], [253, 231, 37]];
function colour(part) {
  const x = Math.min(1, Math.max(0, part || 0)) * 4, i = Math.min(3, Math.floor(x));
  return stops[i].map((c, k) => c + (x - i) * (stops[i + 1][k] - c));
}
function bar(canvas) {
  canvas.width = 256; canvas.height = 1;
  const pen = canvas.getContext('2d');
  for (let i = 0; i < 256; i++) {
    pen.fillStyle = 'rgb(' + colour(i / 255).map(Math.round) + ')';
    pen.fillRect(i, 0, 1, 1);
  }
}
function range(arrays) {
  let low = Infinity, high = -Infinity;
  for (const a of arrays) { low = Math.min(low, a.low); high = Math.max(high, a.high); }
  return low <= high ? [low, high] : [0, 1];
}
const units = { speed: 'm/s', diameter: 'm', id: '', pressure: 'Pa', void_fraction: '-',
                force: 'N', fluid_force: 'N', contact_force: 'N' };
const part = (x, [low, high]) => high > low ? (x - low) / (high - low) : 0.5;

function ends(parent) {
  const box = add(parent, 'div', null, { className: 'ends' });
  const spans = [0, 1, 2].map(() => add(box, 'span'));
  return (limits, name) => [short(limits[0]), name + (units[name] ? ' [' + units[name] + ']' : ''),
                            short(limits[1])].forEach((t, i) => { spans[i].textContent = t; });
}
function choose(parent, label, names, then) {
  if (!names.length) return { value: undefined };
  const s = add(parent, 'select', null, { onchange: then, title: label });
  s.setAttribute('aria-label', label);
  for (const n of names) add(s, 'option', n.replace(/_/g, ' '), { value: n });
  return s;
}

/* --- the scene ---------------------------------------------------------------------- */

/* A point drawn as a lit ball of its size. */
const ball = {
  vertexShader: 'attribute float size; attribute vec3 tint; varying vec3 seen; uniform float tall;' +
    'void main() { seen = tint; vec4 p = modelViewMatrix * vec4(position, 1.0);' +
    'gl_Position = projectionMatrix * p;' +
    'gl_PointSize = size > 0.0 ? max(2.0, tall * size * projectionMatrix[1][1] / gl_Position.w * 0.5) : 0.0;' +
    'if (size <= 0.0) gl_Position = vec4(2.0, 2.0, 2.0, 1.0); }',
  fragmentShader: 'varying vec3 seen; void main() { vec2 q = 2.0 * gl_PointCoord - 1.0;' +
    'float r = dot(q, q); if (r > 1.0) discard;' +
    'gl_FragColor = vec4(seen * (0.45 + 0.55 * sqrt(1.0 - r) * (1.0 - 0.3 * (q.y + q.x))), 1.0); }',
};

function extent(run) {
  const low = [Infinity, Infinity, Infinity], high = [-Infinity, -Infinity, -Infinity];
  const take = (k, a, b) => { low[k] = Math.min(low[k], a); high[k] = Math.max(high[k], b); };
  if (run.box) run.box.forEach((l, k) => take(k, 0, l));
  for (const a of run.arrays.filter(a => a.axis >= 0).slice(0, 9))
    for (let k = 0; k < 3; k++) take((a.axis + 1 + k) % 3, a.box[2 * k], a.box[2 * k + 1]);
  if (!(low[0] <= high[0]))
    for (const a of run.arrays.filter(a => a.name === 'position' || a.name === 'triangle'))
      a.value.forEach((x, i) => isFinite(x) && take(i % 3, x, x));
  return low[0] <= high[0] ? [low, high] : null;
}

/* Turned by pointer and arrow keys, zoomed by wheel, two fingers, + and -. */
function turning(canvas, view, draw) {
  const at = new Map();
  const zoom = f => { view.far = Math.min(20, Math.max(0.15, view.far * f)); draw(); };
  const turn = (x, y) => { view.round -= x; view.above = Math.min(1.55, Math.max(-1.55, view.above + y)); draw(); };
  const apart = () => { const [a, b] = [...at.values()]; return Math.hypot(a.x - b.x, a.y - b.y); };
  canvas.tabIndex = 0;
  canvas.onpointerdown = e => { canvas.setPointerCapture(e.pointerId); at.set(e.pointerId, { x: e.clientX, y: e.clientY }); };
  canvas.onpointerup = canvas.onpointercancel = e => at.delete(e.pointerId);
  canvas.onpointermove = e => {
    const p = at.get(e.pointerId);
    if (!p) return;
    const before = at.size === 2 ? apart() : 0, x = e.clientX - p.x, y = e.clientY - p.y;
    p.x = e.clientX; p.y = e.clientY;
    if (before) zoom(before / (apart() || 1)); else turn(0.01 * x, 0.01 * y);
  };
  canvas.onwheel = e => { e.preventDefault(); zoom(Math.exp(0.001 * e.deltaY)); };
  canvas.onkeydown = e => {
    const k = { ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1] }[e.key];
    if (k) turn(...k); else if (e.key === '+') zoom(0.9); else if (e.key === '-') zoom(1.1); else return;
    e.preventDefault();
  };
}

/* The array of a state: the last one at or before the time. */
function at(run, series, name, t, axis, place) {
  let found = null;
  for (const a of run.arrays)
    if (a.series === series && a.name === name && !(axis >= 0 && (a.axis !== axis || a.at !== place)) &&
        a.time <= t * (1 + 1e-12) + 1e-300 && (!found || a.time >= found.time)) found = a;
  return found;
}

function scene(parent, run) {
  const balls = ['particles', 'bodies', 'body_clumps'], flat = ['surfaces', 'body_surfaces'];
  const has = run.arrays.some(a => a.name === 'position' || a.name === 'triangle');
  const limit = extent(run);
  if (!has || !limit) return null;
  if (typeof THREE === 'undefined') {
    add(parent, 'p', 'The build had no three.js (Debian: libjs-three): there is no scene to turn.');
    return null;
  }
  const canvas = document.createElement('canvas');
  const gl = canvas.getContext('webgl', { antialias: true, preserveDrawingBuffer: true });
  if (!gl) {
    add(parent, 'p', 'This browser has no WebGL: there is no scene to turn.');
    return null;
  }
  const tools = add(parent, 'div', null, { className: 'tools' });
  parent.append(canvas);
  canvas.setAttribute('aria-label', 'the scene; arrow keys turn it, + and - zoom');
  const name = choose(tools, 'colour', ['speed', 'diameter', 'force', 'fluid_force', 'contact_force', 'id'].filter(n =>
    run.arrays.some(a => a.name === n)), () => show());
  const legend = add(parent, 'canvas', null, { className: 'bar' }), say = ends(parent);
  bar(legend);
  const renderer = new THREE.WebGLRenderer({ canvas, context: gl }), world = new THREE.Scene();
  const camera = new THREE.PerspectiveCamera(35, 1, 1, 10), [low, high] = limit;
  const size = Math.hypot(...high.map((h, k) => h - low[k])) || 1, middle = high.map((h, k) => (h + low[k]) / 2);
  const up = new THREE.Vector3(...run.up).normalize();
  const wide = [0, 1, 2].map(k => high[k] - low[k]).map((w, k) => Math.abs(up.getComponent(k)) > 0.7 ? -1 : w);
  const side = new THREE.Vector3().setComponent(wide.indexOf(Math.max(...wide)), 1);
  side.addScaledVector(up, -side.dot(up)).normalize();
  const front = new THREE.Vector3().crossVectors(side, up);
  const view = { round: 0.35, above: 0.2, far: 1.75 };
  const box = new THREE.Box3(new THREE.Vector3(...low), new THREE.Vector3(...high));
  world.add(new THREE.Box3Helper(box, 0x8090a0), new THREE.HemisphereLight(0xffffff, 0x667788, 1));
  const drawn = [], uniforms = { tall: { value: 1 } };
  let now = 0;
  function draw() {
    const w = canvas.clientWidth || 300, h = canvas.clientHeight || 300, c = Math.cos(view.above);
    renderer.setPixelRatio(window.devicePixelRatio || 1);
    renderer.setSize(w, h, false);
    renderer.setClearColor(getComputedStyle(document.body).getPropertyValue('--soft').trim() || '#eee');
    uniforms.tall.value = h * renderer.getPixelRatio();
    camera.aspect = w / h;
    camera.near = 0.01 * size; camera.far = 50 * size;
    camera.up.copy(up);
    const far = view.far * size * Math.max(1, h / w);
    camera.position.set(...middle).addScaledVector(front, far * c * Math.cos(view.round))
      .addScaledVector(side, far * c * Math.sin(view.round)).addScaledVector(up, far * Math.sin(view.above));
    camera.lookAt(...middle);
    camera.updateProjectionMatrix();
    renderer.render(world, camera);
  }
  const outlined = new Set();
  for (const a of run.arrays) if (a.name === 'body') a.value.forEach(i => outlined.add(Math.round(i)));
  function points(series) {
    const x = at(run, series, 'position', now), tinted = name.value && at(run, series, name.value, now);
    const d = at(run, series, 'diameter', now), id = at(run, series, 'id', now);
    if (!x || !x.value.length) return;
    const limits = range(run.arrays.filter(a => a.series === series && a.name === name.value));
    if (tinted && drawn.length === 0) say(limits, name.value);
    const n = x.value.length / 3, tint = new Float32Array(3 * n), width = new Float32Array(n);
    for (let i = 0; i < n; i++) {
      tint.set(tinted ? colour(part(tinted.value[i], limits)).map(c => c / 255) : [0.6, 0.6, 0.65], 3 * i);
      width[i] = series === 'bodies' && id && outlined.has(Math.round(id.value[i])) ? 0 :
                 d ? d.value[i] : 0.01 * size;
    }
    const g = new THREE.BufferGeometry(), b = (v, k) => new THREE.BufferAttribute(v, k);
    g.setAttribute('position', b(x.value.map(v => isFinite(v) ? v : 0), 3));
    g.setAttribute('tint', b(tint, 3));
    g.setAttribute('size', b(width, 1));
    drawn.push(new THREE.Points(g, new THREE.ShaderMaterial({ ...ball, uniforms })));
  }
  function triangles(series) {
    const x = at(run, series, 'triangle', now);
    if (!x || !x.value.length) return;
    const g = new THREE.BufferGeometry();
    g.setAttribute('position', new THREE.BufferAttribute(x.value.map(v => isFinite(v) ? v : 0), 3));
    g.computeVertexNormals();
    drawn.push(new THREE.Mesh(g, new THREE.MeshLambertMaterial({ color: series === 'surfaces' ? 0x9aa7b5 : 0xd08a3c,
      side: THREE.DoubleSide, transparent: series === 'surfaces', opacity: series === 'surfaces' ? 0.35 : 1 })));
  }
  function show(t) {
    if (t !== undefined) now = t;
    for (const o of drawn.splice(0)) { world.remove(o); o.geometry.dispose(); o.material.dispose(); }
    balls.forEach(points);
    flat.forEach(triangles);
    drawn.forEach(o => { o.frustumCulled = false; world.add(o); });
    draw();
  }
  turning(canvas, view, draw);
  window.addEventListener('resize', draw);
  return show;
}

/* --- a slice of the fluid ----------------------------------------------------------- */

function slice(parent, run) {
  const all = run.arrays.filter(a => a.series === 'fluid');
  if (!all.length) return null;
  const tools = add(parent, 'div', null, { className: 'tools' });
  const fields = ['void_fraction', 'pressure', 'speed'].filter(f => all.some(a => a.name === f && a.high > a.low));
  const field = choose(tools, 'field', fields.length ? fields : [all[0].name], () => show());
  const axes = [2, 0, 1].filter(k => all.some(a => a.axis === k));
  axes.sort((a, b) => [b, a].map(k => { const s = all.find(q => q.axis === k).size; return s[0] * s[1]; })
    .reduce((x, y) => x - y));
  const places = new Map();
  for (const k of axes) {
    const of = all.filter(a => a.axis === k), [from, to] = of[0].box.slice(4), middle = (from + to) / 2;
    for (const p of [...new Set(of.map(a => a.at))].sort((a, b) => Math.abs(a - middle) - Math.abs(b - middle)))
      places.set(Math.abs(p - middle) < 0.01 * (to - from) ? 'middle of ' + 'xyz'[k] : 'xyz'[k] + ' = ' + short(p) + ' m', [k, p]);
  }
  const plane = choose(tools, 'plane', [...places.keys()], () => show());
  const canvas = add(parent, 'canvas', null, { className: 'field' });
  const legend = add(parent, 'canvas', null, { className: 'bar' }), say = ends(parent);
  const upward = run.up.map(Math.abs).indexOf(Math.max(...run.up.map(Math.abs)));
  bar(legend);
  let now = 0;
  function show(t) {
    if (t !== undefined) now = t;
    const [axis, place] = places.get(plane.value), a = at(run, 'fluid', field.value, now, axis, place);
    canvas.style.visibility = a ? 'visible' : 'hidden'; // a slice of the last state alone, say
    if (!a) return;
    const limits = range(all.filter(q => q.name === field.value)), flip = (axis + 1) % 3 === upward;
    const [nu, nv] = a.size, [w, h] = flip ? [nv, nu] : [nu, nv], down = run.up[flip ? (axis + 1) % 3 : (axis + 2) % 3] < 0;
    canvas.width = w; canvas.height = h;
    const lx = a.box[flip ? 3 : 1] - a.box[flip ? 2 : 0], ly = a.box[flip ? 1 : 3] - a.box[flip ? 0 : 2];
    canvas.style.width = 460 * lx / ly + 'px';
    canvas.style.aspectRatio = lx + ' / ' + ly;
    const pen = canvas.getContext('2d'), image = pen.createImageData(w, h);
    for (let y = 0; y < h; y++)
      for (let x = 0; x < w; x++) {
        const u = flip ? y : x, v = flip ? x : y, value = a.value[u + nu * v];
        const q = 4 * (x + w * (down ? y : h - 1 - y));
        if (isFinite(value)) image.data.set([...colour(part(value, limits)), 255], q);
      }
    pen.putImageData(image, 0, 0);
    say(limits, field.value);
  }
  return show;
}

/* --- states in time ----------------------------------------------------------------- */

function moving(parent, run) {
  const two = document.createElement('div');
  two.className = 'two';
  const shows = [['scene', scene], ['slice', slice]].map(([id, make]) => {
    const box = add(two, 'div', null, { id });
    return make(box, run);
  }).filter(f => f);
  const tools = add(parent, 'div', null, { className: 'tools' });
  parent.append(two);
  [...two.children].forEach(c => c.children.length || c.remove());
  if (run.picture) add(add(parent, 'details'), 'summary', 'bed.png, the picture that the run made')
    .parentNode.append(Object.assign(new Image(), { src: 'data:image/png;base64,' + run.picture, alt: 'bed.png' }));
  if (!shows.length || !run.times.length) {
    if (!two.children.length) add(parent, 'p', 'The folder has no state of this run.');
    return;
  }
  const play = add(tools, 'button', 'Play'), back = add(tools, 'button', '‹', { title: 'one state back' });
  const on = add(tools, 'button', '›', { title: 'one state on' });
  const slider = add(tools, 'input', null, { type: 'range', min: 0, max: run.times.length - 1,
                                             value: run.times.length - 1, title: 'time' });
  const clock = add(tools, 'output');
  let timer = null;
  const show = i => {
    slider.value = i;
    clock.textContent = 't = ' + short(run.times[+slider.value]) + ' s';
    for (const f of shows) f(run.times[+slider.value]);
  };
  const stop = () => { clearInterval(timer); timer = null; play.textContent = 'Play'; };
  slider.oninput = () => { stop(); show(+slider.value); };
  back.onclick = () => { stop(); show(+slider.value - 1); };
  on.onclick = () => { stop(); show(+slider.value + 1); };
  play.onclick = () => {
    if (timer) return stop();
    play.textContent = 'Stop';
    timer = setInterval(() => play.isConnected ? show((+slider.value + 1) % run.times.length) : stop(), 120);
  };
  show(run.times.length - 1);
}

/* --- plots -------------------------------------------------------------------------- */

function plots(parent, runs) {
  const held = runs.filter(r => r.history && r.history.rows.length);
  if (!held.length) return void add(parent, 'p', 'There is no history.csv.');
  const names = [...new Set(held.flatMap(r => r.history.names.slice(1)))], graphs = [];
  add(parent, 'p', 'Drag across a plot to zoom all of them; a double click shows all again.' +
      (held.length > 1 ? ' The runs: ' + held.map(r => r.i + 1 + ' = ' + r.folder).join(', ') + '.' : ''), { className: 'note' });
  if (typeof Dygraph === 'undefined')
    add(parent, 'p', 'The build had no dygraphs (Debian: libjs-dygraphs): the last row stands for the plots.', { className: 'note' });
  const grid = add(parent, 'div', null, { className: 'plots' });
  for (const name of names) {
    const from = held.filter(r => r.history.names.includes(name)), rows = new Map();
    from.forEach((r, k) => {
      const c = r.history.names.indexOf(name);
      for (const row of r.history.rows) {
        if (!rows.has(row[0])) rows.set(row[0], [row[0], ...from.map(() => null)]);
        rows.get(row[0])[k + 1] = isFinite(row[c]) ? row[c] : NaN;
      }
    });
    const figure = add(grid, 'figure'), last = from.map(r => r.history.rows[r.history.rows.length - 1][r.history.names.indexOf(name)]);
    figure.dataset.column = name;
    add(figure, 'figcaption', name + ', last ' + last.map(short).join(' and '));
    if (typeof Dygraph === 'undefined') continue;
    const zoomed = (a, b) => graphs.forEach(g => g.updateOptions({ dateWindow: [a, b] }));
    graphs.push(new Dygraph(add(figure, 'div', null, { className: 'plot' }), [...rows.values()].sort((a, b) => a[0] - b[0]), {
      labels: ['t', ...from.map(r => 'run ' + (r.i + 1))], colors: from.map(r => ['#0b63a5', '#d1711a', '#1d7a3a', '#8e44ad'][r.i % 4]),
      connectSeparatedPoints: true, legend: 'follow', axisLabelFontSize: 11, digitsAfterDecimal: 6, sigFigs: 5,
      axes: { x: { axisLabelFormatter: x => String(+x.toPrecision(6)) }, y: { axisLabelFormatter: x => String(+x.toPrecision(4)).replace('e+', 'e'), axisLabelWidth: 62 } },
      zoomCallback: zoomed }));
  }
}

/* Means on lines; where the case names what was measured there, its points. */
function profiles(parent, runs) {
  const names = [...new Set(runs.flatMap(r => r.profiles.map(p => p.name)))].filter(n => !n.endsWith('_measured'));
  if (!names.length) return void add(parent, 'p', 'The case asks for no profiles (output.profiles).');
  const grid = add(parent, 'div', null, { className: 'plots' });
  for (const name of names) {
    const shown = runs.flatMap(r => ['', '_measured'].flatMap(end => r.profiles.filter(p => p.name === name + end && p.rows)
      .map(p => ({ p, points: end !== '', label: (end ? 'measured' : 'computed') + (runs.length > 1 ? ', run ' + (r.i + 1) : '') }))));
    const figure = add(grid, 'figure'), heads = shown[0].p.names;
    figure.dataset.profile = name;
    add(figure, 'figcaption', heads[1] + ' over ' + heads[0] + ', ' + name + ': ' + shown.map(s => s.p.rows.length + ' ' + s.label).join(', '));
    if (typeof Dygraph === 'undefined') continue;
    const rows = shown.flatMap((s, k) => s.p.rows.map(r => [r[0], ...shown.map((q, i) => i === k ? r[1] : null)]));
    new Dygraph(add(figure, 'div', null, { className: 'plot' }), rows.sort((a, b) => a[0] - b[0]), {
      labels: ['x', ...shown.map(s => s.label)], colors: shown.map((s, i) => s.points ? '#555' : ['#0b63a5', '#d1711a', '#1d7a3a', '#8e44ad'][i % 4]),
      series: Object.fromEntries(shown.map(s => [s.label, s.points ? { strokeWidth: 0, drawPoints: true, pointSize: 3 } : {}])),
      connectSeparatedPoints: true, legend: 'follow', axisLabelFontSize: 11, sigFigs: 4,
      axes: { x: { axisLabelFormatter: x => String(+x.toPrecision(6)) }, y: { axisLabelFormatter: x => String(+x.toPrecision(4)), axisLabelWidth: 62 } } });
  }
}

/* --- numbers ------------------------------------------------------------------------ */

function rows(parent, title, list) {
  if (!list.length) return;
  const box = add(parent, 'div', null, { className: 'wide' });
  add(box, 'h3', title);
  const body = add(box, 'table');
  for (const [name, value, more, share, bad] of list) {
    const row = add(body, 'tr', null, { className: bad ? 'warn' : '' });
    add(row, 'td', name);
    add(row, 'td', finite(value) ? short(value) : value === null ? 'none' : String(value), { className: 'number' }).dataset.key = name;
    if (share !== undefined) add(add(row, 'td', null, { className: 'share' }), 'i').style.width = Math.min(100, 100 * share || 0) + '%';
    add(row, 'td', more);
  }
}

function figures(parent, run, known) {
  const s = run.summary, box = add(parent, 'div', null, { className: 'two' });
  const flat = (o, before) => Object.entries(o || {}).flatMap(([k, v]) =>
    v !== null && typeof v === 'object' ? flat(v, before + k + '.') : [[before + k, v]]);
  rows(box, 'Numerics: the worst of all steps', Object.entries(s.worst || {}).map(([k, v]) =>
    [k, v, k in limits ? 'at most ' + limits[k][0] + ': ' + limits[k][1] : '', undefined, over(k, v)]));
  const all = (s.seconds || {}).total;
  rows(box, 'Where the time went [s]', Object.entries(s.seconds || {}).filter(([k]) => k !== 'processor')
    .map(([k, v]) => [k, v, percent(v / all), v / all]));
  rows(box, 'Effects: mean share of weight or drag', Object.entries(s.effects || {}).map(([k, e]) =>
    [k, e && e.mean_share, 'at most ' + percent((e || {}).largest_share) + ', in ' + short((s.effect_seconds || {})[k]) + ' s', (e || {}).mean_share]));
  const off = known.filter(k => /^effects\.[a-z_]+$/.test(k.name)).map(k => [k.name.slice(8), k.what])
    .filter(([k]) => !(k in (s.effects || {})) && !new RegExp('^\\s*' + k + '\\s*=', 'm').test(run.text));
  rows(box, 'Effects that are off: share as winnow check ' + run.folder + '/case.cfg estimates it, and what is missed without them',
       off.map(([k, what]) => [k, run.estimates.get(k) || {}, what]).map(([k, e, what]) =>
         [k, finite(e.share) ? e.share : 'off', e.says ? e.says + ' (' + what + ')' : what, finite(e.share) ? e.share : 0, /^needed/.test(e.says)]));
  rows(box, 'Means of the second half', flat(s.second_half, ''));
  rows(box, 'The run', flat(s, '').filter(([k]) => !/^(worst|seconds|effects|second_half|effect_seconds)\./.test(k)));
}

/* --- the case ----------------------------------------------------------------------- */

function keys() {
  const text = document.getElementById('keys').textContent.split('\n').filter(l => l);
  return text.map(l => l.split('\t')).map(([path, what, unit, source]) =>
    ({ name: path, path: new RegExp('^' + path.replace(/[.*+?^${}()|[\]\\]/g, '\\$&').replace('<patch>', '[^.]+') + '$'), what, unit, source }));
}

/* Of each equation by its key: what it says, its formula, where it is explained. */
function equations() {
  const all = new Map(), of = k => all.get(k) || all.set(k, { says: '', as: '', formula: '', section: [] }).get(k);
  for (const l of document.getElementById('equations').textContent.split('\n').filter(l => l)) {
    const [key, kind, name, file] = l.split('\t'), e = of(key.replace(':', ' '));
    if (kind === 'section') e.section.push(name + ' (' + file + ')'); else e[kind] = name;
  }
  return all;
}

/* "XS11 2.11-2.13, 3.5" are four of them. */
function named(source) {
  let book = '';
  return source.split(', ').flatMap(part => {
    const m = /^(?:(\S+) )?(\S+)$/.exec(part), range = m && /^(.*?)(\d+)-\1(\d+)$/.exec(m[2]);
    if (!m) return [];
    book = m[1] || book;
    if (!range) return [book + ' ' + m[2]];
    return Array.from({ length: Math.min(30, range[3] - range[2] + 1) }, (_, i) => book + ' ' + range[1] + (+range[2] + i));
  });
}

function explain(parent, source, book) {
  const found = named(source).filter(k => book.has(k));
  if (!found.length) return void parent.append(' — ' + source);
  const box = add(parent, 'details');
  add(box, 'summary', source);
  for (const k of found) {
    const e = book.get(k), same = book.get(e.as) || e;
    add(box, 'p', k + ': ' + [e.says, e.as && 'the same as ' + e.as, e.formula || same.formula].filter(t => t).join('; ') +
        (same.section.length ? '. Explained in ' + same.section.join(', ') : '') + '.', { className: 'note' });
  }
}

function lines(parent, run, known, book) {
  const body = add(add(parent, 'div', null, { className: 'wide' }), 'table'), within = [];
  for (const line of run.text.split('\n')) {
    const m = /^\s*([A-Za-z_][\w-]*)\s*=/.exec(line), row = add(body, 'tr');
    const path = m && [...within, m[1]].filter(p => p).join('.'), key = m && known.find(k => k.path.test(path));
    add(add(row, 'td'), 'code', line);
    const cell = add(row, 'td', key ? key.what + (key.unit ? ' [' + key.unit + ']' : '') : '');
    if (key && key.source) explain(cell, key.source, book);
    const bare = line.replace(/"(?:[^"\\]|\\.)*"/g, '').replace(/#.*/, '');
    let first = m && m[1];
    for (const c of bare) {
      if (c === '{' || c === '(') { within.push(first); first = null; }
      if (c === '}' || c === ')') within.pop();
    }
  }
}

/* --- all of it ---------------------------------------------------------------------- */

const runs = [...document.querySelectorAll('section.run')].map(read);
{
  const main = document.querySelector('main'), known = keys(), book = equations();
  const part = title => { const s = add(main, 'section'); add(s, 'h2', title); return add(s, 'div'); };
  document.title = runs.map(r => r.title).join(', ') + ' – Winnow';
  const cards = add(document.querySelector('header'), 'div', null, { className: 'cards' });
  runs.forEach(r => verdict(cards, r));
  const pick = runs.length > 1 && choose(add(document.querySelector('header'), 'p', 'Scene, numbers and case of '),
    'run', runs.map((r, i) => i + 1 + ': ' + r.folder), () => fill());
  const places = { moving: part('The scene'), plots: part('In time: history.csv'), profiles: part('On lines: profiles'), figures: part('Numbers'), lines: part('The case') };
  const fill = () => {
    const run = runs[pick ? pick.selectedIndex : 0];
    for (const name of ['moving', 'figures', 'lines']) places[name].textContent = '';
    moving(places.moving, run);
    figures(places.figures, run, known);
    lines(places.lines, run, known, book);
  };
  plots(places.plots, runs);
  profiles(places.profiles, runs);
  fill();
}
