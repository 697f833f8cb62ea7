// A camera that goes around a point, z up, and how mouse, keys and fingers move it. Distances in metres, angles in radians.
'use strict';

const FIELD_OF_VIEW = 0.6;

class Camera {
  constructor() {
    this.azimuth = 0.9;
    this.elevation = 0.35;
    this.distance = 1;
    this.target = [0, 0, 0];
  }

  /** Towards the viewer. */
  get backward() {
    const c = Math.cos(this.elevation);
    return [c * Math.cos(this.azimuth), c * Math.sin(this.azimuth), Math.sin(this.elevation)];
  }
  get right() {
    return [-Math.sin(this.azimuth), Math.cos(this.azimuth), 0];
  }
  get up() {
    const b = this.backward, r = this.right;
    return [b[1] * r[2] - b[2] * r[1], b[2] * r[0] - b[0] * r[2], b[0] * r[1] - b[1] * r[0]];
  }
  get eye() {
    return this.target.map((x, k) => x + this.distance * this.backward[k]);
  }

  turn(azimuth, elevation) {
    this.azimuth += azimuth;
    this.elevation = Math.max(-1.55, Math.min(1.55, this.elevation + elevation));
  }

  zoom(factor) {
    this.distance = Math.max(1e-4, Math.min(1e4, this.distance * factor));
  }

  /** By shares of what is in view. */
  move(right, up) {
    const scale = this.distance * 2 * Math.tan(FIELD_OF_VIEW / 2);
    this.target = this.target.map((x, k) => x + scale * (right * this.right[k] + up * this.up[k]));
  }

  /** Shows all of these points, from the side that the camera is on. `aspect`: width over height of the view. */
  frame(points, aspect) {
    if (points.length === 0) points = [[0, 0, 0]];
    const along = (axis, p) => axis[0] * p[0] + axis[1] * p[1] + axis[2] * p[2];
    const axes = [this.right, this.up, this.backward];
    const middle = axes.map((axis) => {
      let low = Infinity, high = -Infinity;
      for (const p of points) {
        low = Math.min(low, along(axis, p));
        high = Math.max(high, along(axis, p));
      }
      return (low + high) / 2;
    });
    this.target = [0, 1, 2].map((k) => axes.reduce((sum, axis, i) => sum + axis[k] * middle[i], 0));
    const slope = 0.88 * Math.tan(FIELD_OF_VIEW / 2);
    this.distance = 1e-3;
    for (const p of points) {
      const [x, y, z] = axes.map((axis, i) => along(axis, p) - middle[i]);
      this.distance = Math.max(this.distance, z + Math.max(Math.abs(x) / aspect, Math.abs(y)) / slope);
    }
  }

  /** A function from points to [x, y] in pixels, and the distance in front of the eye. */
  projection(width, height) {
    const eye = this.eye, b = this.backward, r = this.right, u = this.up;
    const scale = height / 2 / Math.tan(FIELD_OF_VIEW / 2);
    return (x, y, z) => {
      const dx = x - eye[0], dy = y - eye[1], dz = z - eye[2];
      const depth = -(dx * b[0] + dy * b[1] + dz * b[2]);
      const toPixels = scale / Math.max(depth, 1e-9);
      return [width / 2 + toPixels * (dx * r[0] + dy * r[1] + dz * r[2]), height / 2 - toPixels * (dx * u[0] + dy * u[1] + dz * u[2]), depth];
    };
  }
}

/** Lets the user move the camera; calls `changed(moving)` after each move. */
function steer(camera, stage, changed) {
  const fingers = new Map();
  const turnOrMove = (event, dx, dy) => {
    if (event.buttons & 6 || event.shiftKey || fingers.size > 1) camera.move(-dx / stage.clientHeight, dy / stage.clientHeight);
    else camera.turn(-dx * 0.008, dy * 0.008);
  };
  const spread = () => {
    const [a, b] = [...fingers.values()];
    return Math.hypot(a[0] - b[0], a[1] - b[1]);
  };
  stage.addEventListener('pointerdown', (event) => {
    stage.setPointerCapture(event.pointerId);
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
  });
  stage.addEventListener('pointermove', (event) => {
    const before = fingers.get(event.pointerId);
    if (!before) return;
    const wide = fingers.size === 2 ? spread() : 0;
    fingers.set(event.pointerId, [event.clientX, event.clientY]);
    if (wide > 0) camera.zoom(wide / Math.max(spread(), 1));
    turnOrMove(event, (event.clientX - before[0]) / fingers.size, (event.clientY - before[1]) / fingers.size);
    changed(true);
  });
  for (const end of ['pointerup', 'pointercancel']) {
    stage.addEventListener(end, (event) => {
      if (fingers.delete(event.pointerId)) changed(false);
    });
  }
  stage.addEventListener('contextmenu', (event) => event.preventDefault());
  stage.addEventListener('wheel', (event) => {
    event.preventDefault();
    camera.zoom(Math.exp(Math.max(-60, Math.min(60, event.deltaY)) * 0.003));
    changed(false);
  }, {passive: false});
  stage.addEventListener('keydown', (event) => {
    const moves = {
      ArrowLeft: () => camera.turn(-0.1, 0), ArrowRight: () => camera.turn(0.1, 0), ArrowUp: () => camera.turn(0, 0.1),
      ArrowDown: () => camera.turn(0, -0.1), '+': () => camera.zoom(0.87), '-': () => camera.zoom(1.15),
    };
    if (!moves[event.key]) return;
    event.preventDefault();
    moves[event.key]();
    changed(false);
  });
}
