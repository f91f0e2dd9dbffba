'use strict';
// The body in three dimensions: both versions as grids of vertices, blended, drawn with WebGL 2.
// x points to the rear, y to the right, z up; see io/report_mesh.hpp for the data.
(() => {
  const vertexShader = `#version 300 es
    in vec3 p0, p1, n0, n1;
    in float h0, h1, k0, k1;
    uniform mat4 camera;
    uniform float blend, mirror;
    out vec3 normal, point;
    out float value, known;
    void main() {
      vec3 turned = vec3(1.0, mirror, 1.0);
      point = mix(p0, p1, blend) * turned;
      normal = mix(n0, n1, blend) * turned;
      value = mix(h0, h1, blend);
      known = mix(k0, k1, blend);
      gl_Position = camera * vec4(point, 1.0);
    }`;
  const fragmentShader = `#version 300 es
    precision highp float;
    in vec3 normal, point;
    in float value, known;
    uniform vec3 eye;
    uniform float period;
    uniform int look;
    uniform sampler2D scale;
    out vec4 color;
    vec3 sky(vec3 d) {
      float light = mix(0.40, 0.95, smoothstep(-0.05, 0.8, d.z));
      light = mix(0.78, light, smoothstep(-0.25, 0.05, d.z));
      light += 0.80 * smoothstep(0.30, 0.42, d.z) * (1.0 - smoothstep(0.50, 0.62, d.z));
      light += 0.90 * smoothstep(0.84, 0.94, d.z);
      return vec3(0.985, 0.995, 1.02) * light;
    }
    vec3 paint(vec3 n, vec3 d, float facing) {
      vec3 base = vec3(0.46, 0.55, 0.66) * (0.62 + 0.38 * n.z);
      float mirrored = 0.16 + 0.4 * pow(1.0 - facing, 4.0);
      return base + mirrored * sky(d);
    }
    float zebra(vec3 d) {
      float stripe = degrees(acos(clamp(d.z, -1.0, 1.0))) / period;
      float edge = max(fwidth(stripe), 1e-4);
      float wave = abs(fract(stripe) - 0.5) - 0.25;
      return clamp(0.5 + wave / edge, 0.0, 1.0);
    }
    void main() {
      vec3 n = normalize(normal), to_eye = normalize(eye - point);
      float facing = dot(n, to_eye);
      vec3 d = 2.0 * facing * n - to_eye;
      float form = 0.72 + 0.28 * max(0.0, dot(n, normalize(to_eye + vec3(0.0, 0.0, 0.8))));
      vec3 chosen = paint(n, d, max(facing, 0.0));
      if (look == 1) chosen = form * mix(vec3(0.96), vec3(0.12, 0.13, 0.16), zebra(d));
      vec3 mapped = known > 0.5 ? texture(scale, vec2(0.5 + 0.5 * value, 0.5)).rgb : vec3(0.59, 0.60, 0.63);
      if (look == 2) chosen = form * mapped;
      color = vec4(facing < -0.12 ? vec3(0.20, 0.22, 0.25) : chosen, 1.0);
    }`;

  function bytes(id) {
    const text = atob(document.getElementById(id).textContent);
    return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  }

  function program(gl) {
    const linked = gl.createProgram();
    [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]].forEach(([kind, text]) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      gl.attachShader(linked, shader);
    });
    gl.linkProgram(linked);
    if (!gl.getProgramParameter(linked, gl.LINK_STATUS)) throw new Error(gl.getProgramInfoLog(linked));
    return linked;
  }

  // Two triangles per cell of a face; all faces share them.
  function gridTriangles(cells) {
    const indices = [];
    for (let i = 0; i < cells; ++i) {
      for (let j = 0; j < cells; ++j) {
        const a = i * (cells + 1) + j, b = a + cells + 1;
        indices.push(a, a + 1, b, b, a + 1, b + 1);
      }
    }
    return new Uint16Array(indices);
  }

  // A perspective camera at azimuth and elevation (degrees) that looks at the middle of the body.
  function camera(view, aspect) {
    const radians = Math.PI / 180, a = view.azimuth * radians, e = view.elevation * radians;
    const away = [-Math.cos(a) * Math.cos(e), -Math.sin(a) * Math.cos(e), Math.sin(e)];
    const right = [Math.sin(a), -Math.cos(a), 0];
    const up = [away[1] * right[2] - away[2] * right[1], away[2] * right[0] - away[0] * right[2],
      away[0] * right[1] - away[1] * right[0]];
    const distance = 5.0, near = 3.0, far = 7.0, lift = 0.1;
    const zoom = view.zoom * distance * Math.min(1.0, aspect / 2.0);
    const f = [zoom / aspect, zoom, -(far + near) / (far - near)];
    const matrix = [];
    for (let k = 0; k < 3; ++k) {
      matrix.push(f[0] * right[k], f[1] * up[k] - lift * away[k], f[2] * away[k], -away[k]);
    }
    matrix.push(0, lift * distance, -f[2] * distance - 2 * far * near / (far - near), distance);
    return { matrix, eye: away.map((x) => distance * x) };
  }

  function viewer(section) {
    const canvas = section.querySelector('canvas');
    const gl = canvas.getContext('webgl2', { antialias: true, alpha: true });
    if (!gl) return;
    section.hidden = false;
    const cells = Number(section.dataset.cells), stride = 16, vertices = (cells + 1) ** 2;
    const mirrored = [...section.dataset.mirrored].map((flag) => flag === '1');
    const linked = program(gl), home = { azimuth: 38, elevation: 16, zoom: 2.15 };
    const view = { ...home }, state = { blend: 1, look: 0, waiting: false };
    const uniform = (name) => gl.getUniformLocation(linked, name);

    const buffers = ['mesh-before', 'mesh-after'].map((id) => {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, bytes(id), gl.STATIC_DRAW);
      return buffer;
    });
    const triangles = gridTriangles(cells);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
    const colors = bytes('map-colors');
    gl.bindTexture(gl.TEXTURE_2D, gl.createTexture());
    gl.pixelStorei(gl.UNPACK_ALIGNMENT, 1);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGB, colors.length / 3, 1, 0, gl.RGB, gl.UNSIGNED_BYTE, colors);
    [gl.TEXTURE_WRAP_S, gl.TEXTURE_WRAP_T].forEach((k) => gl.texParameteri(gl.TEXTURE_2D, k, gl.CLAMP_TO_EDGE));
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);

    // Where the vertices of a face are, in both bodies.
    function useFace(face) {
      buffers.forEach((buffer, k) => {
        gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
        [['p', 3, 0], ['h', 1, 6], ['n', 3, 8], ['k', 1, 14]].forEach(([name, size, offset]) => {
          const at = gl.getAttribLocation(linked, name + k);
          gl.enableVertexAttribArray(at);
          gl.vertexAttribPointer(at, size, gl.SHORT, true, stride, face * vertices * stride + offset);
        });
      });
    }

    function draw() {
      state.waiting = false;
      const density = Math.min(2, window.devicePixelRatio || 1);
      canvas.width = Math.max(1, Math.round(canvas.clientWidth * density));
      canvas.height = Math.max(1, Math.round(canvas.clientHeight * density));
      gl.viewport(0, 0, canvas.width, canvas.height);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      gl.enable(gl.DEPTH_TEST);
      gl.useProgram(linked);
      const { matrix, eye } = camera(view, canvas.width / canvas.height);
      gl.uniformMatrix4fv(uniform('camera'), false, matrix);
      gl.uniform3fv(uniform('eye'), eye);
      gl.uniform1f(uniform('blend'), state.blend);
      gl.uniform1i(uniform('look'), state.look);
      gl.uniform1f(uniform('period'), Number(section.dataset.stripe));
      mirrored.forEach((twice, face) => {
        useFace(face);
        (twice ? [1, -1] : [1]).forEach((side) => {
          gl.uniform1f(uniform('mirror'), side);
          gl.drawElements(gl.TRIANGLES, triangles.length, gl.UNSIGNED_SHORT, 0);
        });
      });
    }
    const redraw = () => {
      if (!state.waiting) requestAnimationFrame(draw);
      state.waiting = true;
    };
    const turn = (right, up) => {
      view.azimuth -= right;
      view.elevation = Math.min(89, Math.max(-89, view.elevation + up));
      redraw();
    };
    const zoomBy = (factor) => {
      view.zoom = Math.min(6, Math.max(0.6, view.zoom * factor));
      redraw();
    };

    let last = null;
    canvas.addEventListener('pointerdown', (event) => canvas.setPointerCapture((last = event).pointerId));
    canvas.addEventListener('pointermove', (event) => {
      if (!(event.buttons & 1) || !last) return;
      turn(0.35 * (event.clientX - last.clientX), 0.35 * (event.clientY - last.clientY));
      last = event;
    });
    canvas.addEventListener('wheel', (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      zoomBy(Math.exp(-0.004 * event.deltaY));
    }, { passive: false });
    canvas.addEventListener('dblclick', () => { Object.assign(view, home); redraw(); });
    canvas.addEventListener('keydown', (event) => {
      const step = { ArrowLeft: [-5, 0], ArrowRight: [5, 0], ArrowUp: [0, -5], ArrowDown: [0, 5] }[event.key];
      if (step) { event.preventDefault(); turn(...step); }
      if (event.key === '+') zoomBy(1.15);
      if (event.key === '-') zoomBy(1 / 1.15);
    });
    const blend = section.querySelector('.blend');
    if (blend) blend.addEventListener('input', () => { state.blend = Number(blend.value); redraw(); });
    window.reportTabs([...section.querySelectorAll('.tabs button')], (index) => {
      state.look = index;
      section.querySelector('.scale').hidden = index !== 2;
      redraw();
    }, Number(section.dataset.look));
    new ResizeObserver(redraw).observe(canvas);
  }

  const section = document.getElementById('viewer');
  if (section) viewer(section);
})();
