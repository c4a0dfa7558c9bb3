/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Runs a step of the course in its page: the program, compiled to WebAssembly
 * as it is, stands in the page in base64. It calls the functions that begin with
 * pen_ in steps.h, which draw on the canvas here, and prints by fd_write. */
'use strict';
(() => {
  const box = document.getElementById('live');
  const part = name => box.querySelector('.' + name);
  const canvas = part('canvas'), pen = canvas.getContext('2d');
  const native = part('native').textContent;
  let module, program, numbers, said, going, paused, hurry;

  /* ---- What the program calls. */
  const memory = () => program.memory.buffer;
  const text = (at, n) => new TextDecoder().decode(new Uint8Array(memory(), at, n));
  const word = at => {
    const bytes = new Uint8Array(memory());
    let n = 0;
    while (bytes[at + n]) n++;
    return text(at, n);
  };

  let colours = [];
  function look() { // of the page, by day and by night
    const style = getComputedStyle(box);
    colours = ['--ink', '--blue', '--red', '--line'].map(c => style.getPropertyValue(c));
  }
  const page = {
    size(width, height) {
      const scale = canvas.clientWidth / width * (window.devicePixelRatio || 1);
      canvas.style.aspectRatio = width + ' / ' + height;
      canvas.width = Math.round(width * scale);
      canvas.height = Math.round(height * scale);
      pen.setTransform(scale, 0, 0, scale, 0, 0);
      pen.font = '12px sans-serif';
    },
    move(x, y) { pen.beginPath(); pen.moveTo(x, y); },
    line(x, y) { pen.lineTo(x, y); },
    end(colour, width, opacity) {
      pen.globalAlpha = opacity;
      pen.strokeStyle = pen.fillStyle = colours[colour];
      pen.lineWidth = width;
      if (width > 0) pen.stroke(); else pen.fill();
      pen.globalAlpha = 1;
    },
    disc(x, y, r, colour, opacity) {
      pen.beginPath();
      pen.arc(x, y, r, 0, 2 * Math.PI);
      pen.fillStyle = pen.strokeStyle = colours[colour];
      pen.globalAlpha = opacity;
      pen.fill();
      pen.globalAlpha = 1;
      pen.lineWidth = 0.5;
      pen.stroke();
    },
    text(x, y, at) { pen.fillStyle = colours[0]; pen.fillText(word(at), x, y); },
  };

  const system = {
    fd_write(file, list, n, written) {
      const view = new DataView(memory());
      let total = 0;
      for (let k = 0; k < n; k++) {
        const size = view.getUint32(list + 8 * k + 4, true);
        said += text(view.getUint32(list + 8 * k, true), size);
        total += size;
      }
      view.setUint32(written, total, true);
      return 0;
    },
    fd_fdstat_get(file, at) { // a terminal: each line is written at once
      new Uint8Array(memory(), at, 24).fill(0)[0] = 2;
      return 0;
    },
    proc_exit(code) { throw new Error('ends with ' + code); },
  };
  const nothing = new Proxy(system, { get: (all, name) => all[name] || (() => 0) });

  /* ---- Its numbers, as sliders. */
  function instance() {
    said = '';
    program = new WebAssembly.Instance(
      module, { page, wasi_snapshot_preview1: nothing }).exports;
    if (program._initialize) program._initialize();
  }

  function table() { // struct number in steps.h, 40 bytes each
    const view = new DataView(memory()), all = [];
    for (let at = program.numbers_at(); view.getUint32(at, true); at += 40)
      all.push({
        name: word(view.getUint32(at, true)), at: view.getUint32(at + 4, true),
        value: view.getFloat64(view.getUint32(at + 4, true), true),
        low: view.getFloat64(at + 8, true), high: view.getFloat64(at + 16, true),
        grain: view.getFloat64(at + 24, true), meaning: word(view.getUint32(at + 32, true)),
      });
    for (const n of all) n.usual = n.value;
    return all;
  }

  const count = n => n.grain ? Math.round((n.high - n.low) / n.grain) : 60;
  const place = n => n.grain ? Math.round((n.value - n.low) / n.grain)
    : Math.round(60 * Math.log(n.value / n.low) / Math.log(n.high / n.low));
  function value(n, k) { // as many digits as a reader would type
    if (k === 0) return n.low;
    if (k === count(n)) return n.high;
    return n.grain ? Number((n.low + k * n.grain).toPrecision(8))
      : Number((n.low * (n.high / n.low) ** (k / 60)).toPrecision(2));
  }

  function slider(n, k) {
    const label = document.createElement('label');
    const name = document.createElement('span'), range = document.createElement('input');
    n.shown = document.createElement('output');
    name.textContent = n.meaning.replace(/ \[-\]$/, '');
    range.type = 'range';
    range.min = 0;
    range.max = count(n);
    range.step = 1;
    range.value = place(n);
    range.name = n.name;
    range.setAttribute('aria-valuetext', n.value);
    n.shown.textContent = n.name + '=' + n.value;
    range.addEventListener('input', () => {
      n.value = value(n, Number(range.value));
      range.setAttribute('aria-valuetext', n.value);
      n.shown.textContent = n.name + '=' + n.value;
      begin();
    });
    n.range = range;
    label.append(name, range, n.shown);
    part(k < 3 ? 'numbers' : 'more').append(label);
  }

  /* ---- The run. A run takes four seconds at least, so that one can look. */
  const number = name => numbers.find(n => n.name === name).value;

  function begin() {
    instance();
    const view = new DataView(memory());
    for (const n of numbers) view.setFloat64(n.at, n.value, true);
    going = true;
    paused = false;
    hurry = matchMedia('(prefers-reduced-motion: reduce)').matches ||
      location.hash === '#hurry';
    attempt(() => program.start());
    say();
  }

  function attempt(what) { // false if the program has ended itself
    try {
      what();
      return true;
    } catch (error) {
      if (!/^ends with/.test(error.message)) throw error;
      going = false;
      say();
      return false;
    }
  }

  function say() {
    const changed = numbers.filter(n => n.value !== n.usual)
      .map(n => ' ' + n.name + '=' + n.value).join('');
    part('command').textContent = 'build/steps/' + box.dataset.name + changed;
    part('said').textContent = going ? '...' : said;
    part('beside').textContent = going || changed ? ''
      : said === native ? 'The same as the native program printed when this page was made.'
      : 'The native program printed, when this page was made:\n' + native;
    part('pause').textContent = paused ? 'Go on' : 'Pause';
    box.dataset.state = going ? 'runs' : 'done';
  }

  function frame() {
    requestAnimationFrame(frame);
    if (!going || paused || !program) return;
    const steps = number('end') / number('dt'), from = performance.now();
    const most = hurry ? Infinity : Math.ceil(steps / 240);
    let some = 1, done = 0, more = true;
    const ran = attempt(() => {
      while (more && done < most && performance.now() - from < (hurry ? 50 : 14)) {
        const batch = Math.min(some, most - done);
        more = program.advance(batch) !== 0;
        done += batch;
        some = Math.min(2 * some, 256);
      }
      if (more) return;
      going = false;
      program.report();
      say();
    });
    if (ran) draw();
  }

  function draw() {
    look();
    attempt(() => program.draw());
  }

  async function open() {
    const bytes = Uint8Array.from(atob(part('wasm').textContent.trim()), c => c.charCodeAt(0));
    module = await WebAssembly.compile(bytes);
    instance();
    numbers = table();
    numbers.forEach(slider);
    part('again').addEventListener('click', begin);
    part('pause').addEventListener('click', () => {
      if (going) paused = !paused;
      say();
    });
    part('to-end').addEventListener('click', () => {
      hurry = true;
      paused = false;
    });
    part('usual').addEventListener('click', () => {
      for (const n of numbers) {
        n.value = n.usual;
        n.range.value = place(n);
        n.shown.textContent = n.name + '=' + n.value;
      }
      begin();
    });
    addEventListener('resize', () => { if (!going) draw(); });
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => {
      if (!going) draw();
    });
    begin();
    frame();
  }
  open();
})();
