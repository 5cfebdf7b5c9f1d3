"use strict";
// Draws the motion of the tippe-top (animation.cpp) on its canvas: floor, traces, shadow, and the top as a surface of
// revolution whose stripes show its spin. Lengths in m.
for (const stage of document.querySelectorAll("figure.stage")) {
  const data = JSON.parse(stage.querySelector("script").textContent);
  const [canvas, button, slider, speed, output] =
    ["canvas", "button", "input", "select", "output"].map((name) => stage.querySelector(name));
  const pen = canvas.getContext("2d");
  const rows = data.body.length, end = (rows - 1) * data.step;
  const column = (name) => data[name].values.map((x) => x * data[name].unit);
  const [x, y, z, ex, ey, ez, chi, spin] =
    ["x_s", "y_s", "z_s", "axis_x", "axis_y", "axis_z", "chi", "omega_z"].map(column);

  // LG03 5.4. The body ends where the floor can no longer touch it, as in Figure 7.
  const a = [0.003, 0.016], r = [0.015, 0.005];
  const rim = Math.acos((r[0] - r[1]) / (a[1] - a[0])) - Math.PI / 60;
  const arc = (centre, radius, from, to, n, part) => Array.from({ length: n + 1 }, (_, k) => {
    const angle = from + (to - from) * k / n;
    return { along: centre + radius * Math.cos(angle), out: radius * Math.sin(angle), part };
  });
  const profile = [...arc(a[0], r[0], Math.PI, rim, 16, "body"),
    { along: a[0] + r[0] * Math.cos(rim), out: r[1], part: "body" }, ...arc(a[1], r[1], Math.PI / 2, 0, 5, "stick")];
  const sectors = 36;

  let time = 0, playing = false, last = 0, turn = -0.6, tilt = 0.25;
  const contacts = ["body", "tip"], colours = { body: "#d55e00", tip: "#0072b2" };

  const state = (t) => {
    const at = Math.min(t / data.step, rows - 1), k = Math.min(Math.floor(at), rows - 2), w = at - k;
    const mix = (list) => list[k] * (1 - w) + list[k + 1] * w;
    const e = [mix(ex), mix(ey), mix(ez)], length = Math.hypot(...e);
    return { k: w < 0.5 ? k : k + 1, s: [mix(x), mix(y), mix(z)], e: e.map((c) => c / length), chi: mix(chi), spin: mix(spin) };
  };
  const cross = (p, q) => [p[1] * q[2] - p[2] * q[1], p[2] * q[0] - p[0] * q[2], p[0] * q[1] - p[1] * q[0]];
  const dot = (p, q) => p[0] * q[0] + p[1] * q[1] + p[2] * q[2];

  // Parallel projection, from the direction `towards`.
  const camera = (look, width, height) => {
    const [c, d, ct, st] = [Math.cos(turn), Math.sin(turn), Math.cos(tilt), Math.sin(tilt)];
    const towards = [d * ct, -c * ct, st], right = [c, d, 0], up = cross(towards, right);
    const scale = Math.min(width / 0.09, height / 0.058), centre = [look[0], look[1], 0.014];
    return {
      towards,
      at: (p) => {
        const away = p.map((v, i) => v - centre[i]);
        return [width / 2 + scale * dot(away, right), height / 2 - scale * dot(away, up)];
      },
    };
  };
  const path = (points) => {
    pen.beginPath();
    points.forEach((p, i) => (i ? pen.lineTo(...p) : pen.moveTo(...p)));
  };

  const floor = (view, look) => {
    pen.strokeStyle = "#dfe3e7";
    pen.lineWidth = 1;
    const reach = 0.16, cell = 0.01, near = (v) => Math.round(v / cell) * cell;
    for (let d = -reach; d <= reach + 1e-9; d += cell) {
      path([view.at([near(look[0]) + d, look[1] - reach, 0]), view.at([near(look[0]) + d, look[1] + reach, 0])]);
      pen.stroke();
      path([view.at([look[0] - reach, near(look[1]) + d, 0]), view.at([look[0] + reach, near(look[1]) + d, 0])]);
      pen.stroke();
    }
  };

  // Where a contact was closed, on the floor below the centre of its sphere.
  const traces = (view, k) => contacts.forEach((name, i) => {
    pen.strokeStyle = colours[name];
    pen.lineWidth = 1.6;
    pen.beginPath();
    for (let j = 0, down = false; j <= k; ++j) {
      const closed = data[name][j] !== "o";
      if (closed) {
        const p = view.at([x[j] + a[i] * ex[j], y[j] + a[i] * ey[j], 0]);
        if (down) pen.lineTo(...p); else pen.moveTo(...p);
      }
      down = closed;
    }
    pen.stroke();
  });

  // Of light from above: two discs and what is between them.
  const shadow = (view, { s, e }) => {
    pen.fillStyle = "rgba(40, 45, 50, 0.2)";
    const discs = contacts.map((_, i) => ({ c: [s[0] + a[i] * e[0], s[1] + a[i] * e[1]], r: r[i] }));
    const away = Math.atan2(e[1], e[0]), gap = Math.hypot(discs[1].c[0] - discs[0].c[0], discs[1].c[1] - discs[0].c[1]);
    const ring = (disc, from, to) => Array.from({ length: 33 }, (_, k) => {
      const angle = from + (to - from) * k / 32;
      return view.at([disc.c[0] + disc.r * Math.cos(angle), disc.c[1] + disc.r * Math.sin(angle), 0]);
    });
    if (gap <= r[0] - r[1]) path(ring(discs[0], 0, 2 * Math.PI));
    else {
      const wide = Math.acos((r[0] - r[1]) / gap);
      path([...ring(discs[0], away + wide, away + 2 * Math.PI - wide), ...ring(discs[1], away - wide, away + wide)]);
    }
    pen.fill();
  };

  const top = (view, { s, e, chi: angle }) => {
    const flat = Math.hypot(e[0], e[1]);
    const nodes = flat > 1e-9 ? [-e[1] / flat, e[0] / flat, 0] : [1, 0, 0], third = cross(e, nodes);
    const ring = Array.from({ length: sectors + 1 }, (_, j) => {
      const phi = angle + 2 * Math.PI * j / sectors, [c, d] = [Math.cos(phi), Math.sin(phi)];
      return nodes.map((n, i) => c * n + d * third[i]);
    });
    const point = (p, j) => s.map((v, i) => v + p.along * e[i] + p.out * ring[j][i]);
    const light = [0.35, -0.45, 0.82], faces = [];
    for (let i = 0; i + 1 < profile.length; ++i) {
      for (let j = 0; j < sectors; ++j) {
        const [p, q] = [profile[i], profile[i + 1]];
        const corners = [point(p, j), point(p, j + 1), point(q, j + 1), point(q, j)];
        const across = [0, 1, 2].map((n) => corners[2][n] - corners[0][n]);
        const along = [0, 1, 2].map((n) => corners[3][n] - corners[1][n]);
        const normal = cross(across, along), size = Math.hypot(...normal);
        if (dot(normal, view.towards) <= 0) continue;
        const shade = 0.62 + 0.38 * Math.max(0, dot(normal, light) / size);
        const stripe = Math.floor(j / 6) % 2, base = q.part === "stick"
          ? (stripe ? [226, 178, 112] : [205, 150, 84]) : (stripe ? [120, 175, 214] : [222, 236, 246]);
        const colour = `rgb(${base.map((v) => Math.round(v * shade)).join()})`;
        const middle = [0, 1, 2].map((n) => (corners[0][n] + corners[2][n]) / 2);
        faces.push({ corners, colour, depth: dot(middle, view.towards) });
      }
    }
    faces.sort((f, g) => f.depth - g.depth);
    pen.lineWidth = 0.7;
    for (const face of faces) {
      path(face.corners.map(view.at));
      pen.closePath();
      pen.fillStyle = pen.strokeStyle = face.colour;
      pen.fill();
      pen.stroke();
    }
  };

  const draw = () => {
    const ratio = devicePixelRatio || 1, width = canvas.clientWidth, height = canvas.clientHeight;
    if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
      canvas.width = Math.round(width * ratio);
      canvas.height = Math.round(height * ratio);
    }
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    pen.clearRect(0, 0, width, height);
    pen.lineJoin = "round";
    const now = state(time);
    const view = camera(now.s, width, height);
    floor(view, now.s);
    traces(view, now.k);
    shadow(view, now);
    top(view, now);
    const theta = Math.atan2(Math.hypot(now.e[0], now.e[1]), now.e[2]) * 180 / Math.PI;
    const words = { o: "open", s: "slips", t: "sticks" };
    output.textContent = `t = ${time.toFixed(3)} s   θ = ${theta.toFixed(1)}°   ω₃ = ${now.spin.toFixed(0)} rad/s   ` +
      `body: ${words[data.body[now.k]]}   stick: ${words[data.tip[now.k]]}`;
    slider.value = 1000 * time / end;
  };

  const frame = (clock) => {
    if (!playing) return;
    time = Math.min(end, time + Math.min(clock - last, 100) / 1000 * Number(speed.value));
    last = clock;
    if (time >= end) play(false);
    draw();
    if (playing) requestAnimationFrame(frame);
  };
  const play = (on) => {
    playing = on;
    button.textContent = on ? "❚❚" : "▶";
    button.setAttribute("aria-label", on ? "Pause" : "Play");
    if (!on) return;
    if (time >= end) time = 0;
    last = performance.now();
    requestAnimationFrame(frame);
  };
  button.addEventListener("click", () => play(!playing));
  slider.addEventListener("input", () => { time = end * slider.value / 1000; draw(); });
  canvas.addEventListener("pointerdown", (down) => {
    canvas.setPointerCapture(down.pointerId);
    const from = [down.clientX, down.clientY, turn, tilt];
    const move = (event) => {
      turn = from[2] - (event.clientX - from[0]) * 0.008;
      tilt = Math.min(1.5, Math.max(0.03, from[3] + (event.clientY - from[1]) * 0.006));
      draw();
    };
    canvas.addEventListener("pointermove", move);
    canvas.addEventListener("pointerup", () => canvas.removeEventListener("pointermove", move), { once: true });
  });
  addEventListener("resize", draw);
  draw();
}
