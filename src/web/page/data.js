// What src/web/view_data.cpp wrote: meshes on a grid of integers, and trees of hulls. Lengths in metres.
'use strict';

function readData() {
  const data = JSON.parse(document.getElementById('view-data').textContent);
  const text = atob(document.getElementById('geometry').textContent.trim());
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  data.buffer = bytes.buffer;
  return data;
}

/** The triangles of a block one after another, nine coordinates each, in the mesh's frame. Kept with the block. */
function trianglesOf(block, data) {
  if (block.soup) return block.soup;
  const points = new Uint16Array(data.buffer, block.offset, 3 * block.vertices);
  const start = block.offset + 4 * Math.ceil(6 * block.vertices / 4);
  const Index = {1: Uint8Array, 2: Uint16Array, 4: Uint32Array}[block.index];
  const corners = new Index(data.buffer, start, 3 * block.triangles);
  const soup = new Float32Array(9 * block.triangles);
  for (let i = 0; i < corners.length; ++i) {
    for (let k = 0; k < 3; ++k) soup[3 * i + k] = block.origin[k] + block.step * points[3 * corners[i] + k];
  }
  return block.soup = soup;
}

/** Where a point of an element's frame is when the robot is at rest. `pose`: 3 x 4 by rows. */
function placed(pose, p) {
  return [0, 4, 8].map((row) => pose[row] * p[0] + pose[row + 1] * p[1] + pose[row + 2] * p[2] + pose[row + 3]);
}

/** The nodes of a mesh that are no other's child: one, unless it was not merged. */
function rootsOf(mesh) {
  const children = new Set();
  for (const node of mesh.nodes) children.add(node.left).add(node.right);
  return mesh.nodes.map((node, id) => id).filter((id) => !children.has(id));
}

/** The coarsest cut whose nodes protrude by at most `tolerance`, but for leaves. */
function cutAt(mesh, tolerance) {
  const open = rootsOf(mesh), cut = [];
  while (open.length > 0) {
    const id = open.pop(), node = mesh.nodes[id];
    if (node.left < 0 || node.bound <= tolerance) cut.push(id);
    else open.push(node.left, node.right);
  }
  return cut;
}

/** The first leaf below a node: what gives its hull a colour that lasts while hulls merge. */
function firstLeaf(mesh, id) {
  while (mesh.nodes[id].left >= 0) id = mesh.nodes[id].left;
  return id;
}

/** The bounds at which some mesh of a model gets fewer hulls, ascending. */
function stepsOf(model, data) {
  const bounds = new Set();
  for (const element of model.elements) {
    for (const node of data.meshes[element.mesh].nodes) if (node.left >= 0) bounds.add(node.bound);
  }
  return [...bounds].sort((a, b) => a - b);
}
