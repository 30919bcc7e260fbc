// The picture: the program's own shaders (cave/bodies/shaders) in WebGL 2, over legs that the engine prepares.
const kLegFloats = 68, kLegsInRow = 60;
const kLegs = { rest: 0, one: 1, oneSpinning: 2, aroundTurn: 3, many: 4, manySpinning: 5 };

class Picture {
  constructor(canvas, content, engine) {
    this.canvas = canvas;
    this.content = content;
    this.engine = engine;
    this.about = content.about;
    this.begin();
  }

  get isThere() { return this.gl !== null; }

  begin() {
    const gl = this.canvas.getContext("webgl2", { alpha: false, antialias: true, preserveDrawingBuffer: true });
    this.gl = gl;
    if (!gl) return;
    this.parallel = gl.getExtension("KHR_parallel_shader_compile");
    this.programs = new Map();
    this.meshes = this.about.meshes.map(mesh => this.makeMesh(mesh));
    this.legs = this.makeTexture();
    this.colours = this.makeTexture();
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 1, 1, 0, gl.RGBA, gl.FLOAT, new Float32Array(4));
    this.hasColours = false;
    this.lastEffects = null;
  }

  makeTexture() {
    const { gl } = this, texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    for (const side of [gl.TEXTURE_MIN_FILTER, gl.TEXTURE_MAG_FILTER]) gl.texParameteri(gl.TEXTURE_2D, side, gl.NEAREST);
    return texture;
  }

  makeMesh(of) {
    const { gl, content } = this, places = content.column(of.places), normals = content.column(of.normals);
    const surfaces = content.column(of.surfaces), lit = content.column(of.lit), indices = content.column(of.indices);
    const count = places.length / 3, numbers = new Float32Array(10 * count), bytes = new Uint8Array(numbers.buffer);
    for (let i = 0; i < count; ++i) {
      for (let axis = 0; axis < 3; ++axis) {
        const from = axis * count + i;
        numbers[10 * i + axis] = of.middle_m[axis] + (places[from] / 32767) * of.half_m[axis];
        numbers[10 * i + 3 + axis] = normals[from] / 32767;
        numbers[10 * i + 6 + axis] = surfaces[from];
      }
      for (let light = 0; light < 4; ++light) bytes[40 * i + 36 + light] = lit[light * count + i];
    }
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ARRAY_BUFFER, numbers, gl.STATIC_DRAW);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, indices, gl.STATIC_DRAW);
    for (let input = 0; input < 3; ++input) {
      gl.enableVertexAttribArray(input);
      gl.vertexAttribPointer(input, 3, gl.FLOAT, false, 40, 12 * input);
    }
    gl.enableVertexAttribArray(3);
    gl.vertexAttribPointer(3, 4, gl.UNSIGNED_BYTE, true, 40, 36);
    gl.bindVertexArray(null);
    return { array, count: indices.length, vertices: count };
  }

  textsOf(key) {
    const { parts, variants } = this.about.shaders;
    if (!variants[key]) throw new Error("no shader " + key);
    return variants[key].map(places => places.map(place => parts[place]).join(""));
  }

  // Returns a program; while it is compiled in the background, and nobody waits, null.
  program(key, waits, solves) {
    const name = solves ? key + "/solve" : key;
    let made = this.programs.get(name);
    if (!made) {
      made = this.compiled(this.textsOf(key), solves);
      this.programs.set(name, made);
    }
    if (made.uniforms) return made;
    const { gl } = this;
    if (!waits && this.parallel && !gl.getProgramParameter(made.program, this.parallel.COMPLETION_STATUS_KHR)) return null;
    if (!gl.getProgramParameter(made.program, gl.LINK_STATUS)) {
      const logs = made.shaders.map(shader => gl.getShaderInfoLog(shader)).join("\n");
      throw new Error("shader " + name + ": " + logs + gl.getProgramInfoLog(made.program));
    }
    made.uniforms = {};
    for (let i = gl.getProgramParameter(made.program, gl.ACTIVE_UNIFORMS); i-- > 0;) {
      const uniform = gl.getActiveUniform(made.program, i).name.replace("[0]", "");
      made.uniforms[uniform] = gl.getUniformLocation(made.program, uniform);
    }
    gl.useProgram(made.program);
    gl.uniform1i(made.uniforms.legTexels || null, 0);
    gl.uniform1i(made.uniforms.colourTexels || null, 1);
    return made;
  }

  compiled(texts, solves) {
    const { gl } = this, program = gl.createProgram();
    if (solves) {
      // The place where a vertex is drawn, read back: what the graphics card has solved.
      texts[0] = texts[0].replace("void main() {", "out vec4 solved;\nvoid main() {")
        .replace("existsFor = ", "solved = vec4(sight.drawn, boardTime_m - appears_m);\n  existsFor = ");
      gl.transformFeedbackVaryings(program, ["solved"], gl.INTERLEAVED_ATTRIBS);
    }
    const shaders = [gl.VERTEX_SHADER, gl.FRAGMENT_SHADER].map((kind, i) => {
      const shader = gl.createShader(kind);
      gl.shaderSource(shader, texts[i]);
      gl.compileShader(shader);
      gl.attachShader(program, shader);
      return shader;
    });
    ["vertexMC", "normalMC", "surfaceMC", "litMC"].forEach((input, at) => gl.bindAttribLocation(program, at, input));
    gl.linkProgram(program);
    return { program, shaders, uniforms: null };
  }

  // Sets what one eye sees with these effects (bits). `ghosts`: moments of which there are ghosts, each with its event.
  look(eye, headFromBoard, effects, ghosts) {
    const { engine, gl } = this;
    const layers = [{ moment: 0, event: eye.event }, ...ghosts].map(({ moment, event }) => ({
      moment, ...engine.look(event, headFromBoard, effects, moment), frame: engine.frames(headFromBoard, effects, moment) }));
    let legs = 0;
    for (const layer of layers) {
      layer.first = legs;
      legs += layer.legs.length / kLegFloats;
    }
    const rows = Math.max(1, Math.ceil(legs / kLegsInRow)), texels = new Float32Array(rows * kLegsInRow * kLegFloats);
    for (const layer of layers) texels.set(layer.legs, layer.first * kLegFloats);
    gl.activeTexture(gl.TEXTURE1);
    if (!this.hasColours && effects & 8) {
      gl.bindTexture(gl.TEXTURE_2D, this.colours);
      gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, 1024, 9, 0, gl.RGBA, gl.FLOAT, engine.colours());
      this.hasColours = true;
    }
    gl.bindTexture(gl.TEXTURE_2D, this.colours);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.legs);
    gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA32F, kLegsInRow * 17, rows, 0, gl.RGBA, gl.FLOAT, texels);
    this.seen = { eye, effects, layers };
  }

  // Which of the shaders' sorts of legs a body has. A round body is drawn as if it did not spin.
  sortOf(layer, body, part) {
    if (body === 0) return layer.moment ? kLegs.one : kLegs.rest;
    const first = layer.ranges[3 * body], count = layer.ranges[3 * body + 1], { legs } = layer;
    const leg = (i, at) => legs[kLegFloats * (first + i) + at];
    let spins = false, glides = false;
    for (let i = 0; i < count; ++i) {
      spins = spins || !part.isRound && leg(i, 63) > 0;
      glides = glides || leg(i, 51) > 0;
    }
    if (glides || count > 2 || spins && count === 2) return spins ? kLegs.manySpinning : kLegs.many;
    if (!spins) return count === 2 ? kLegs.aroundTurn : kLegs.one;
    return leg(0, 65) === 0 && leg(0, 63) <= this.about.fewSpinSteps ? kLegs.oneSpinning : kLegs.manySpinning;
  }

  // All that is drawn: each part with its program. Null while some are compiled.
  plan(waits) {
    const { about, seen } = this, plan = [];
    let whole = true;
    // First what rests and always looks the same, so that shadows lie on all of it.
    const isStill = part => part.body === 0 && !part.isClock;
    const parts = [...about.parts.filter(isStill), ...about.parts.filter(part => !isStill(part))];
    for (const layer of seen.layers) {
      for (const part of parts) {
        const isGhost = layer.moment > 0;
        if (isGhost && (part.body === 0 || part.isDecal)) continue;
        const key = [this.sortOf(layer, part.body, part), isGhost ? about.ghostPaint : part.paint, seen.effects, layer.moment].join("/");
        const program = this.program(key, waits);
        whole = whole && program !== null;
        plan.push({ layer, part, program });
      }
    }
    return whole ? plan : null;
  }

  // Draws what was looked at into a part of the canvas, pixels from the lower left.
  draw(clip, port, plan) {
    const { gl } = this;
    gl.viewport(...port);
    gl.enable(gl.SCISSOR_TEST);
    gl.scissor(...port);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.LEQUAL);
    gl.depthMask(true);
    gl.clearColor(0, 0, 0, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    for (const { layer, part, program } of plan) {
      const blends = part.isDecal || layer.moment > 0;
      gl.useProgram(program.program);
      this.setUniforms(program, clip, layer, part);
      if (blends) gl.enable(gl.BLEND); else gl.disable(gl.BLEND);
      gl.depthMask(!part.isDecal);
      const mesh = this.meshes[part.mesh];
      gl.bindVertexArray(mesh.array);
      const draw = () => gl.drawElements(gl.TRIANGLES, mesh.count, gl.UNSIGNED_INT, 0);
      if (layer.moment > 0 && !part.isRound) { // of a body with hollows the nearest surface alone: the glass is even
        gl.colorMask(false, false, false, false);
        draw();
        gl.colorMask(true, true, true, true);
      }
      draw();
    }
    gl.bindVertexArray(null);
    gl.depthMask(true);
    gl.disable(gl.SCISSOR_TEST);
  }

  setUniforms({ uniforms }, clip, layer, part) {
    const { gl, about } = this, { eye } = this.seen, { frame } = layer, { body } = part;
    const first = layer.ranges[3 * body], isGhost = layer.moment > 0;
    const own = layer.legs.subarray(kLegFloats * first, kLegFloats * (first + 1));
    const set = (name, how, ...values) => { if (uniforms[name]) gl[how](uniforms[name], ...values); };
    const matrix = (name, m) => set(name, "uniformMatrix4fv", false, new Float32Array(m));
    matrix("clipFromDrawn", clip);
    matrix("boardFromDrawn", frame.boardFromDrawn);
    matrix("drawnFromSeen", frame.drawnFromSeen);
    matrix("drawnFromBody", [own[9], own[13], own[17], 0, own[10], own[14], own[18], 0, own[11], own[15], own[19], 0,
      own[4], own[5], own[6], 1]);
    set("headOnBoard", "uniform4fv", new Float32Array(frame.headOnBoard));
    set("eyeOnBoard_m", "uniform3fv", new Float32Array(eye.event.slice(1)));
    set("eyeExposure", "uniform3fv", new Float32Array(frame.exposure));
    set("lamps_m", "uniform3fv", new Float32Array(about.lamps_m.flat()));
    set("hall_m", "uniform4fv", new Float32Array(about.hall_m));
    this.setLamps(set, eye);
    const whole_s = Math.floor(eye.event[0]);
    set("observedWhole_s", "uniform1i", whole_s);
    set("observedPart_s", "uniform1f", eye.event[0] - whole_s);
    set("lightSpeed_m_s", "uniform1f", about.lightSpeed_m_s);
    set("onlyLeg", "uniform4fv", own);
    set("firstLeg", "uniform1i", layer.first + first);
    set("legCount", "uniform1i", layer.ranges[3 * body + 1]);
    set("appears_m", "uniform1f", Math.max(layer.ranges[3 * body + 2], -1e30));
    set("partColour", "uniform3fv", new Float32Array(part.colour));
    set("roughness", "uniform1f", part.roughness);
    set("seenShare", "uniform1f", 1);
    set("tint", "uniform1f", part.number % 3);
    set("nearer", "uniform1f", isGhost || part.isDecal ? 0.002 : (0.0005 * body) / about.bodies.length);
    if (isGhost) set("ghostColour", "uniform3fv", new Float32Array(about.ghostColours[layer.moment - 1]));
    set("hatch_m", "uniform1f", about.bodies[body].stripes_m);
  }

  // Of lamps that are followed: when they go on, c (t_on - t_o), and where they are from the eye.
  setLamps(set, eye) {
    const { about } = this;
    if (!about.followed.length) return;
    const lamps = [0, 1, 2].map(i => about.followed[i]), on = [0, 0, 0];
    const places = lamps.flatMap(lamp => (lamp ? lamp.place_m.map((x, axis) => x - eye.event[1 + axis]) : [0, 0, 0]));
    lamps.forEach((lamp, i) => {
      if (lamp) on[i] = Math.min(1, Math.max(-1000, about.lightSpeed_m_s * (lamp.on_s - eye.event[0])));
    });
    set("lampsFromEye_m", "uniform3fv", new Float32Array(places));
    set("lampLights", "uniform3fv", new Float32Array(lamps.flatMap(lamp => (lamp ? lamp.light : [0, 0, 0]))));
    set("lampsOn_m", "uniform3fv", new Float32Array(on));
  }

  // Where the graphics card sees places of a body, for the eye that looked last: [x, y, z], or null where unseen.
  solve(body, places) {
    const { gl, about, seen } = this, layer = seen.layers[0];
    const part = about.parts.find(one => one.body === body && !one.isDecal);
    const key = [this.sortOf(layer, body, { isRound: false }), part.paint, seen.effects, 0].join("/");
    const program = this.program(key, true, true);
    const array = gl.createVertexArray(), input = gl.createBuffer(), output = gl.createBuffer();
    const feedback = gl.createTransformFeedback();
    gl.bindVertexArray(array);
    gl.bindBuffer(gl.ARRAY_BUFFER, input);
    gl.bufferData(gl.ARRAY_BUFFER, new Float32Array(places.flat()), gl.STATIC_DRAW);
    gl.enableVertexAttribArray(0);
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, null);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, feedback);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, output);
    gl.bufferData(gl.TRANSFORM_FEEDBACK_BUFFER, 16 * places.length, gl.STREAM_READ);
    gl.useProgram(program.program);
    this.setUniforms(program, new Float64Array(16), layer, part);
    gl.enable(gl.RASTERIZER_DISCARD);
    gl.beginTransformFeedback(gl.POINTS);
    gl.drawArrays(gl.POINTS, 0, places.length);
    gl.endTransformFeedback();
    gl.disable(gl.RASTERIZER_DISCARD);
    const solved = new Float32Array(4 * places.length);
    gl.getBufferSubData(gl.TRANSFORM_FEEDBACK_BUFFER, 0, solved);
    gl.bindBufferBase(gl.TRANSFORM_FEEDBACK_BUFFER, 0, null);
    gl.bindTransformFeedback(gl.TRANSFORM_FEEDBACK, null);
    gl.bindVertexArray(null);
    for (const buffer of [input, output]) gl.deleteBuffer(buffer);
    gl.deleteVertexArray(array);
    gl.deleteTransformFeedback(feedback);
    return places.map((_, i) => (solved[4 * i + 3] < 0 ? null : Array.from(solved.slice(4 * i, 4 * i + 3))));
  }
}
