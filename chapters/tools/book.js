/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Beside every page: search without a server, and the place to return to. */
'use strict';
(() => {
  const main = document.querySelector('main');
  const title = document.querySelector('h1')?.textContent || document.title;
  const page = location.pathname.replace(/.*\//, '') || 'index.html';

  /* ---- Search. The index is read when somebody begins to type. */
  const box = document.getElementById('search'), list = document.getElementById('found');
  let asked = false;
  function find() {
    list.replaceChildren();
    const words = box.value.toLowerCase().split(/\s+/).filter(w => w);
    if (!words.length || typeof sections === 'undefined') return;
    const hits = [];
    for (const [where, name, section, text] of sections) {
      const head = (section + ' ' + name).toLowerCase(), all = head + ' ' + text.toLowerCase();
      if (!words.every(w => all.includes(w))) continue;
      const exact = section.toLowerCase() === words.join(' ');
      const score = words.filter(w => section.toLowerCase().includes(w)).length * 2 +
                    words.filter(w => head.includes(w)).length +
                    (exact ? 5 : 0) + (text ? 0.5 : 0);
      hits.push([score, where, name, section, text]);
    }
    hits.sort((a, b) => b[0] - a[0]);
    for (const [, where, name, section, text] of hits.slice(0, 20)) {
      const item = list.appendChild(document.createElement('li'));
      const link = item.appendChild(document.createElement('a'));
      link.href = where;
      link.textContent = section;
      item.append(name === section ? '' : ' \u2014 ' + name);
      const at = text.toLowerCase().indexOf(words[0]);
      if (at < 0) continue;
      const part = item.appendChild(document.createElement('small'));
      part.textContent = '\u2026' + text.slice(Math.max(0, at - 40), at + 60) + '\u2026';
    }
    if (!hits.length) list.appendChild(document.createElement('li')).textContent = 'Nothing found.';
  }
  box.addEventListener('input', () => {
    if (asked) return find();
    asked = true;
    const script = document.createElement('script');
    script.src = 'search.js';
    script.onload = find;
    document.body.append(script);
  });
  document.addEventListener('keydown', e => {
    if (e.key === '/' && !/INPUT|TEXTAREA/.test(e.target.tagName)) {
      e.preventDefault();
      document.getElementById('menu').checked = true;
      box.focus();
    }
  });

  /* ---- The place to return to: the section at the top of the window. */
  const memory = {
    get(name) { try { return JSON.parse(localStorage.getItem(name)); } catch { return null; } },
    set(name, what) { try { localStorage.setItem(name, JSON.stringify(what)); } catch { /* none */ } },
  };
  function offer(place, words) {
    const link = document.createElement('a');
    link.className = 'return';
    link.href = place.page + '#' + place.id;
    link.textContent = words + place.title + (place.section === place.title ? '' : ': ' + place.section);
    main.prepend(link);
  }
  const last = memory.get('winnow-place'), here = memory.get('winnow-' + page);
  if (page === 'index.html') {
    if (last) offer(last, 'Go on reading: ');
    return;
  }
  if (here && !location.hash) offer(here, 'You were at: ');
  let waiting = 0;
  addEventListener('scroll', () => {
    clearTimeout(waiting);
    waiting = setTimeout(() => {
      const above = [...main.querySelectorAll('h2[id], h3[id]')]
        .filter(h => h.getBoundingClientRect().top < 120).pop();
      if (!above) return;
      const place = { page, id: above.id, title, section: above.textContent };
      memory.set('winnow-place', place);
      memory.set('winnow-' + page, place);
    }, 300);
  });
})();
