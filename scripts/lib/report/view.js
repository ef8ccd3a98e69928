// The view of a body in the browser: surface and slices that turn, coloured by a field, over time. WebGL 2, no library.
"use strict";

const VERTEX = `#version 300 es
in vec3 place; in vec3 motion; in float value; in float group;
uniform vec3 low, extent, motionScale; uniform float factor, stretch; uniform mat3 turn; uniform vec3 centre; uniform float depth; uniform int isLine; uniform vec2 zoom; uniform vec2 shift;
uniform vec2 own[2]; uniform vec2 shown[2];
out vec3 at; out vec3 body; out float share; out float there; out float row;
void main() {
  body = low + extent * place;
  vec3 p = body + factor * motionScale * motion;
  p.y *= stretch;
  at = turn * (p - centre);
  int g = int(group + 0.5);
  float v = own[g].x + value * (own[g].y - own[g].x);
  share = clamp((v - shown[g].x) / max(shown[g].y - shown[g].x, 1e-30), 0.0, 1.0);
  there = value < 0.0 ? 0.0 : 1.0;
  row = group;
  // A line lies in front of the face that it bounds.
  gl_Position = vec4(at.xy * zoom + shift, clamp(-at.z * depth, -0.99, 0.99) - (isLine == 1 ? 0.003 : 0.0), 1.0);
}`;
const FRAGMENT = `#version 300 es
precision highp float; precision highp int;
in vec3 at; in vec3 body; in float share; in float there; in float row;
uniform sampler2D maps; uniform int flat_, cut; uniform int isLine; uniform vec4 plane;
out vec4 colour;
void main() {
  if (cut == 1 && dot(plane.xyz, body) > plane.w) discard;
  if (isLine == 1) { colour = vec4(0.1, 0.1, 0.1, 1.0); return; }
  vec3 c = there < 0.999 ? vec3(0.82) : texture(maps, vec2((share * 255.0 + 0.5) / 256.0, (row + 0.5) / 2.0)).rgb;
  if (flat_ == 0) {
    vec3 n = normalize(cross(dFdx(at), dFdy(at)));
    c *= 0.62 + 0.38 * abs(dot(n, normalize(vec3(0.25, 0.35, 1.0))));
  }
  colour = vec4(c, 1.0);
}`;

class BodyView {
  // `box`: the element to fill; `data`: what report_view.py wrote; `maps`: {name: 256 x 3 bytes}; `unpack`: text -> bytes.
  constructor(box, data, maps, unpack) {
    Object.assign(this, {box, data, maps, unpack});
    this.state = data.times.length - 1;
    this.field = 0;
    this.slice = -1;
    this.otherSide = false;
    this.factor = data.factor;
    this.lines = data.lines;
    this.stretch = data.stretch;
    this.buffers = new Map();
    this.reset();
    this.controls();
    this.gl = this.canvas.getContext("webgl2", {antialias: true, preserveDrawingBuffer: true});
    if (!this.gl) throw new Error("this browser has no WebGL 2");
    this.prepare();
    this.listen();
    new ResizeObserver(() => this.draw()).observe(this.canvas);
  }

  reset() {
    const d = this.data;
    this.turn = d.dim === 3 ? d.turn.slice() : [1, 0, 0, 0, 1, 0, 0, 0, 1];
    this.scale = 1;
    this.shift = [0, 0];
  }

  // What a reader can choose.
  controls() {
    const d = this.data, bar = element("div", "controls");
    const choose = (label, options, act, chosen = 0) => {
      const select = element("select");
      options.forEach((text, i) => select.append(element("option", "", text, {value: i})));
      select.value = chosen;
      select.addEventListener("change", () => { act(Number(select.value)); this.draw(); });
      bar.append(element("label", "", label + " ", {}, [select]));
      return select;
    };
    const slide = (label, min, max, step, value, act) => {
      const input = element("input", "", "", {type: "range", min, max, step, value});
      input.addEventListener("input", () => { act(Number(input.value)); this.draw(); });
      bar.append(element("label", "", label + " ", {}, [input]));
      return input;
    };
    choose("Field", d.fields.map(f => f.label), i => {
      this.field = i;
      // What is known at the wall of the lumen is hidden by the wall.
      if (d.fields[i].ofWalls && this.bodyInput) this.bodyInput.value = this.body = 1;
      this.ranges();
    });
    this.body = 0;
    if (d.liquidPart !== null) this.bodyInput = choose("of", ["the whole body", "the liquids"], i => { this.body = i; });
    if (d.times.length > 1) {
      this.timeInput = slide(d.modal ? "Mode" : "Time", 0, d.times.length - 1, 1, this.state, i => { this.state = i; });
      const play = element("button", "", "\u25b6 play", {type: "button"});
      play.addEventListener("click", () => this.play(play));
      bar.append(play);
    } else if (d.modal) {
      const play = element("button", "", "\u25b6 swing", {type: "button"});
      play.addEventListener("click", () => this.play(play));
      bar.append(play);
    }
    if (d.motionScale) {
      const top = Math.max(1, d.factor) * 3;
      this.factorInput = slide("Displacement \u00d7", 0, top, top / 300, d.factor, f => { this.factor = f; });
    }
    if (d.dim === 2 && d.stretch !== 1) slide("y drawn \u00d7", 1, 2 * d.stretch, 0.5, d.stretch, f => { this.stretch = f; });
    if (d.slices.length) {
      choose("Cut", ["none", ...d.slices.map(s => s.name)], i => { this.slice = i - 1; }, d.firstSlice + 1);
      this.slice = d.firstSlice;
      const side = element("input", "", "", {type: "checkbox"});
      side.addEventListener("change", () => { this.otherSide = side.checked; this.draw(); });
      bar.append(element("label", "", "", {}, [side, " other side"]));
    }
    const mesh = element("input", "", "", {type: "checkbox"});
    mesh.checked = this.lines;
    mesh.addEventListener("change", () => { this.lines = mesh.checked; this.draw(); });
    bar.append(element("label", "", "", {}, [mesh, " mesh"]));
    const again = element("button", "", "reset view", {type: "button"});
    again.addEventListener("click", () => { this.reset(); this.draw(); });
    bar.append(again);
    this.legend = element("div", "legend");
    this.canvas = element("canvas", "body", "", {tabindex: "0", "aria-label": "The body; arrow keys turn it, + and - zoom"});
    this.said = element("div", "said");
    this.box.append(bar, this.canvas, this.legend, this.said);
    this.ranges();
  }

  // Colour bars, whose ends can be changed.
  ranges() {
    const field = this.data.fields[this.field];
    this.shown = field.groups.map(g => [g.low, g.high]);
    this.legend.replaceChildren(...field.groups.map((group, i) => {
      const bar = element("canvas", "bar", "", {width: 256, height: 1}), context = bar.getContext("2d"), image = context.createImageData(256, 1);
      const colours = this.maps[group.map];
      for (let k = 0; k < 256; ++k) image.data.set([colours[3 * k], colours[3 * k + 1], colours[3 * k + 2], 255], 4 * k);
      context.putImageData(image, 0, 0);
      const ends = [0, 1].map(j => {
        const input = element("input", "end", "", {type: "number", step: "any", "aria-label": (j ? "highest" : "lowest") + " colour"});
        input.value = Number((this.shown[i][j] * field.factor).toPrecision(4));
        input.addEventListener("change", () => {
          if (Number.isFinite(input.valueAsNumber)) this.shown[i][j] = input.valueAsNumber / field.factor;
          this.draw();
        });
        return input;
      });
      return element("div", "scale", "", {}, [ends[0], bar, ends[1], ` ${field.label}${group.what ? " in the " + group.what : ""}${field.unit ? " [" + field.unit + "]" : ""}`]);
    }));
  }

  prepare() {
    const gl = this.gl, compile = (kind, text) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader));
      return shader;
    };
    this.program = gl.createProgram();
    gl.attachShader(this.program, compile(gl.VERTEX_SHADER, VERTEX));
    gl.attachShader(this.program, compile(gl.FRAGMENT_SHADER, FRAGMENT));
    gl.linkProgram(this.program);
    if (!gl.getProgramParameter(this.program, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(this.program));
    gl.useProgram(this.program);
    this.uniform = name => gl.getUniformLocation(this.program, name);
    this.texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    for (const [key, value] of [[gl.TEXTURE_MIN_FILTER, gl.NEAREST], [gl.TEXTURE_MAG_FILTER, gl.NEAREST], [gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE],
                                [gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE]]) gl.texParameteri(gl.TEXTURE_2D, key, value);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(1, 1, 1, 1);
  }

  // An array of the data, unpacked once: {array, buffer}. Numbers of two bytes have their high bytes first, then their low bytes.
  async get(packed, kind, target) {
    let found = this.buffers.get(packed);
    if (found) return found;
    const bytes = await this.unpack(packed);
    let array;
    if (kind === "bytes") array = bytes;
    else if (kind === "whole") array = new Uint32Array(bytes.buffer);
    else {
      const n = bytes.length / 2;
      array = kind === "motion" ? new Int16Array(n) : new Uint16Array(n);
      for (let i = 0; i < n; ++i) array[i] = (bytes[i] << 8) | bytes[n + i];
      // Values have 12 bits; the last number says that there is no value.
      if (kind === "value") array = Float32Array.from(array, q => q === 4095 ? -1 : q / 4094);
    }
    const buffer = this.gl.createBuffer();
    this.gl.bindBuffer(target, buffer);
    this.gl.bufferData(target, array, this.gl.STATIC_DRAW);
    found = {array, buffer};
    this.buffers.set(packed, found);
    return found;
  }

  // The parts that are seen, with their arrays of the present state and field.
  async parts() {
    const gl = this.gl, d = this.data, found = [];
    const numbers = [this.body ? d.liquidPart : 0];
    if (this.slice >= 0) numbers.push(1 + this.slice);
    for (const number of numbers) {
      const part = d.parts[number], mesh = part.meshes[part.meshOfState[this.state]];
      if (!mesh || !mesh.n) continue;
      found.push({
        n: mesh.n, isSlice: number > 0 && number !== d.liquidPart,
        place: await this.get(mesh.points, "place", gl.ARRAY_BUFFER),
        group: await this.get(mesh.groups, "bytes", gl.ARRAY_BUFFER),
        triangles: await this.get(mesh.triangles, "whole", gl.ELEMENT_ARRAY_BUFFER),
        edges: await this.get(mesh.edges, "whole", gl.ELEMENT_ARRAY_BUFFER),
        motion: part.motion ? await this.get(part.motion[this.state], "motion", gl.ARRAY_BUFFER) : null,
        value: await this.get(d.fields[this.field].values[number][this.state], "value", gl.ARRAY_BUFFER)});
    }
    return found;
  }

  async draw() {
    if (this.busy) { this.again = true; return; }
    this.busy = true;
    try {
      const parts = await this.parts();
      this.seen = parts;
      this.paint(parts);
    } finally {
      this.busy = false;
    }
    if (this.again) { this.again = false; this.draw(); }
  }

  paint(parts) {
    const gl = this.gl, d = this.data, ratio = Math.min(devicePixelRatio || 1, 2);
    const width = Math.max(1, Math.round(this.canvas.clientWidth * ratio)), height = Math.max(1, Math.round(this.canvas.clientHeight * ratio));
    if (this.canvas.width !== width || this.canvas.height !== height) Object.assign(this.canvas, {width, height});
    gl.viewport(0, 0, width, height);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const field = d.fields[this.field], two = list => list.length > 1 ? list : [list[0], list[0]];
    const rows = two(field.groups).map(g => this.maps[g.map]), pixels = new Uint8Array(2 * 256 * 3);
    rows.forEach((row, i) => pixels.set(row, 768 * i));
    gl.bindTexture(gl.TEXTURE_2D, this.texture);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB8, 256, 2, 0, gl.RGB, gl.UNSIGNED_BYTE, pixels);
    this.measure(width / height);
    const u = this.uniform;
    gl.uniform3fv(u("low"), d.low);
    gl.uniform3fv(u("extent"), d.extent);
    gl.uniform3fv(u("motionScale"), d.motionScale || [0, 0, 0]);
    gl.uniform1f(u("factor"), this.factor * (this.swing ?? 1));
    gl.uniform1f(u("stretch"), this.stretch);
    gl.uniformMatrix3fv(u("turn"), false, this.turn);
    gl.uniform3fv(u("centre"), this.centre);
    gl.uniform1f(u("depth"), 0.5 / (this.depth || 1));
    gl.uniform2fv(u("zoom"), this.zoom);
    gl.uniform2fv(u("shift"), this.shift);
    gl.uniform2fv(u("own"), two(field.groups).flatMap(g => [g.low, g.high]));
    gl.uniform2fv(u("shown"), two(this.shown).flat());
    const slice = d.slices[this.slice], sign = this.otherSide ? -1 : 1;
    for (const part of parts) {
      gl.uniform1i(u("flat_"), d.dim === 2 || part.isSlice ? 1 : 0);
      gl.uniform1i(u("cut"), slice && !part.isSlice ? 1 : 0);
      if (slice) gl.uniform4f(u("plane"), ...slice.normal.map(x => sign * x), sign * slice.distance);
      const bind = (name, source, size, kind, normalised) => {
        const place = gl.getAttribLocation(this.program, name);
        if (place < 0) return;
        if (!source) { gl.disableVertexAttribArray(place); gl.vertexAttrib3f(place, 0, 0, 0); return; }
        gl.bindBuffer(gl.ARRAY_BUFFER, source.buffer);
        gl.enableVertexAttribArray(place);
        gl.vertexAttribPointer(place, size, kind, normalised, 0, 0);
      };
      bind("place", part.place, 3, gl.UNSIGNED_SHORT, true);
      bind("motion", part.motion, 3, gl.SHORT, true);
      bind("value", part.value, 1, gl.FLOAT, false);
      bind("group", part.group, 1, gl.UNSIGNED_BYTE, false);
      gl.uniform1i(u("isLine"), 0);
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, part.triangles.buffer);
      gl.drawElements(gl.TRIANGLES, part.triangles.array.length, gl.UNSIGNED_INT, 0);
      if (this.lines) {
        gl.uniform1i(u("isLine"), 1);
        gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, part.edges.buffer);
        gl.drawElements(gl.LINES, part.edges.array.length, gl.UNSIGNED_INT, 0);
      }
    }
    const factor = this.factor ? `, displacement \u00d7 ${Number(this.factor.toPrecision(3))}` : "";
    this.said.textContent = d.times[this.state] + (d.motionScale ? factor : "") + (this.stretch !== 1 ? `, y drawn \u00d7 ${this.stretch}` : "")
      + (this.pointed ? ` \u2014 ${this.pointed}` : "");
  }

  // Scale and middle of the picture: the body in its box fills the canvas.
  measure(aspect) {
    const d = this.data, s = [1, this.stretch, 1];
    const half = d.extent.map((e, i) => 0.5 * e * s[i]), middle = d.low.map((l, i) => (l + 0.5 * d.extent[i]) * s[i]);
    let x = 0, y = 0;
    for (const signs of [[1, 1, 1], [1, 1, -1], [1, -1, 1], [1, -1, -1]]) {
      const p = this.turned(half.map((h, i) => h * signs[i]), [0, 0, 0]);
      x = Math.max(x, Math.abs(p[0]));
      y = Math.max(y, Math.abs(p[1]));
    }
    // What turns keeps its size: that of the first view.
    if (d.dim === 3) {
      const radius = Math.hypot(...half);
      this.fit ??= Math.max(x / aspect, y, 1e-30);
      x = this.fit * aspect;
      y = this.fit;
      this.depth = radius;
    }
    const size = 1.06 * Math.max(x / aspect, y, 1e-30);
    this.centre = middle;
    this.zoom = [this.scale / (size * aspect), this.scale / size];
  }

  turned(p, centre) {
    const q = p.map((v, i) => v - centre[i]), t = this.turn;
    return [t[0] * q[0] + t[3] * q[1] + t[6] * q[2], t[1] * q[0] + t[4] * q[1] + t[7] * q[2], t[2] * q[0] + t[5] * q[1] + t[8] * q[2]];
  }

  rotate(dx, dy) {
    if (this.data.dim === 2) { this.shift = [this.shift[0] + dx, this.shift[1] + dy]; this.draw(); return; }
    const multiply = (a, b) => [0, 1, 2].flatMap(c => [0, 1, 2].map(r => a[r] * b[3 * c] + a[3 + r] * b[3 * c + 1] + a[6 + r] * b[3 * c + 2]));
    const [ca, sa, cb, sb] = [Math.cos(2 * dx), Math.sin(2 * dx), Math.cos(-2 * dy), Math.sin(-2 * dy)];
    this.turn = multiply([1, 0, 0, 0, cb, sb, 0, -sb, cb], multiply([ca, 0, -sa, 0, 1, 0, sa, 0, ca], this.turn));
    this.draw();
  }

  listen() {
    const canvas = this.canvas, held = new Map();
    let spread = 0;
    const share = (dx, dy) => [2 * dx / canvas.clientWidth, -2 * dy / canvas.clientHeight];
    canvas.addEventListener("pointerdown", e => { canvas.setPointerCapture(e.pointerId); held.set(e.pointerId, e); spread = 0; });
    for (const name of ["pointerup", "pointercancel"]) canvas.addEventListener(name, e => { held.delete(e.pointerId); spread = 0; });
    canvas.addEventListener("pointermove", e => {
      const before = held.get(e.pointerId);
      if (!before) { this.point(e); return; }
      held.set(e.pointerId, e);
      const [dx, dy] = share(e.clientX - before.clientX, e.clientY - before.clientY);
      if (held.size > 1) {
        const [a, b] = [...held.values()], now = Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY);
        if (spread) this.scale *= now / spread;
        spread = now;
        this.shift = [this.shift[0] + dx / 2, this.shift[1] + dy / 2];
        this.draw();
      } else if (e.shiftKey || e.buttons > 1) {
        this.shift = [this.shift[0] + dx, this.shift[1] + dy];
        this.draw();
      } else this.rotate(dx, dy);
    });
    canvas.addEventListener("contextmenu", e => e.preventDefault());
    canvas.addEventListener("wheel", e => { e.preventDefault(); this.scale *= Math.exp(-0.0015 * e.deltaY); this.draw(); }, {passive: false});
    canvas.addEventListener("keydown", e => {
      const way = {ArrowLeft: [-0.1, 0], ArrowRight: [0.1, 0], ArrowUp: [0, 0.1], ArrowDown: [0, -0.1]}[e.key];
      if (way) { e.preventDefault(); this.rotate(...way); }
      if (e.key === "+" || e.key === "-") { this.scale *= e.key === "+" ? 1.2 : 1 / 1.2; this.draw(); }
    });
  }

  // Place and value of the node at the pointer, the nearest to the reader.
  point(event) {
    if (!this.seen || !this.zoom) return;
    const d = this.data, field = d.fields[this.field], box = this.canvas.getBoundingClientRect();
    const x = 2 * (event.clientX - box.left) / box.width - 1, y = 1 - 2 * (event.clientY - box.top) / box.height;
    const slice = d.slices[this.slice], sign = this.otherSide ? -1 : 1;
    let best = null;
    for (const part of this.seen) {
      for (let i = 0; i < part.n; ++i) {
        const body = [0, 1, 2].map(k => d.low[k] + d.extent[k] * part.place.array[3 * i + k] / 65535);
        if (slice && !part.isSlice && sign * (slice.normal.reduce((s, n, k) => s + n * body[k], 0) - slice.distance) > 0) continue;
        const moved = body.map((b, k) => (b + (part.motion ? this.factor * d.motionScale[k] * part.motion.array[3 * i + k] / 32767 : 0))
                                         * (k === 1 ? this.stretch : 1));
        const p = this.turned(moved, this.centre);
        const dx = (p[0] * this.zoom[0] + this.shift[0] - x) * box.width / 2, dy = (p[1] * this.zoom[1] + this.shift[1] - y) * box.height / 2;
        const away = Math.hypot(dx, dy);
        // A near node in front wins over the nearest one behind.
        const cost = away - (d.dim === 3 ? 20 * p[2] / (this.depth || 1) : 0);
        if (away < 14 && (!best || cost < best.cost)) best = {cost, body, value: part.value.array[i], group: part.group.array[i]};
      }
    }
    this.pointed = "";
    if (best) {
      const group = field.groups[Math.min(best.group, field.groups.length - 1)];
      const value = best.value < 0 ? "no value" : Number((field.factor * (group.low + best.value * (group.high - group.low))).toPrecision(4)) + " " + field.unit;
      const place = best.body.slice(0, d.dim).map(v => Number((v * d.placeFactor).toPrecision(4))).join(", ");
      this.pointed = `(${place}) ${d.placeUnit}: ${value}`;
    }
    this.paint(this.seen);
  }

  play(button) {
    if (this.timer) {
      clearInterval(this.timer);
      this.timer = null;
      this.swing = undefined;
      button.textContent = this.data.modal ? "\u25b6 swing" : "\u25b6 play";
      this.draw();
      return;
    }
    button.textContent = "\u25a0 stop";
    const start = performance.now();
    this.timer = setInterval(() => {
      if (this.data.modal) this.swing = Math.sin((performance.now() - start) / 250);
      else {
        this.state = (this.state + 1) % this.data.times.length;
        if (this.timeInput) this.timeInput.value = this.state;
      }
      this.draw();
    }, this.data.modal ? 40 : 150);
  }
}
