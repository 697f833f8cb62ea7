// The table of all inputs: filtered, sorted, and shown a part at a time, as a browser takes long to lay out ten thousand rows.
'use strict';

const PART = 200;
const COLUMNS = ['Input', 'Status', '', 'Meshes', 'Hulls, primitives', 'Bound [mm]', 'Time [s]', 'Memory [MB]', 'Attempts', 'Reason'];
const NAME = 0, STATUS = 1, REPORT = 2, REASON = 9;
const RANK = ['failed', 'incomplete', 'degraded', 'ok'];
const byId = (id) => document.getElementById(id);
const rows = JSON.parse(byId('data').textContent);
let shown = PART, column = STATUS, down = false;

const figure = (value) => value === 0 ? '0' : value < 1000 ? String(Number(value.toPrecision(3))) : Math.round(value).toLocaleString('en');
const key = (row) => column === STATUS ? RANK.indexOf(row[STATUS]) : row[column];

function compare(a, b) {
  const [x, y] = [key(a), key(b)];
  return (x < y ? -1 : x > y ? 1 : 0) * (down ? -1 : 1);
}

function cell(row, i) {
  const td = document.createElement('td');
  if (i === NAME && row[REPORT]) {
    const a = td.appendChild(document.createElement('a'));
    a.href = row[REPORT].split('/').map(encodeURIComponent).join('/');
    a.textContent = row[NAME];
    return td;
  }
  td.textContent = typeof row[i] === 'number' ? figure(row[i]) : row[i];
  td.className = i === STATUS ? `status ${row[i]}` : typeof row[i] === 'number' ? 'number' : '';
  if (i === REASON) td.title = row[i];
  return td;
}

function show() {
  const words = byId('filter').value.toLowerCase().split(/\s+/);
  const found = rows.filter((row) => words.every((word) => [NAME, STATUS, REASON].some((i) => row[i].toLowerCase().includes(word)))).sort(compare);
  const body = document.createElement('tbody');
  for (const row of found.slice(0, shown)) {
    const tr = body.appendChild(document.createElement('tr'));
    COLUMNS.forEach((name, i) => i === REPORT || tr.appendChild(cell(row, i)));
  }
  byId('all').tBodies[0].replaceWith(body);
  byId('shown').textContent = `${Math.min(shown, found.length).toLocaleString('en')} of ${found.length.toLocaleString('en')}`;
  byId('more').hidden = found.length <= shown;
  [...byId('all').tHead.rows[0].cells].forEach((th) => th.ariaSort = Number(th.dataset.column) !== column ? 'none' : down ? 'descending' : 'ascending');
}

COLUMNS.forEach((name, i) => {
  if (i === REPORT) return;
  const th = byId('all').tHead.rows[0].appendChild(document.createElement('th'));
  th.dataset.column = i;
  const button = th.appendChild(document.createElement('button'));
  button.type = 'button';
  button.textContent = name;
  button.addEventListener('click', () => {
    down = column === i ? !down : typeof rows[0]?.[i] === 'number';
    column = i;
    show();
  });
});
byId('filter').addEventListener('input', () => { shown = PART; show(); });
byId('more').addEventListener('click', () => { shown += PART; show(); });
show();
