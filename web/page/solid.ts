// Solids by WebGL2: what core/draw/solid_list.h holds, as web/core/solid.h lays it out. The depth is reversed.
// SPDX-License-Identifier: GPL-3.0-or-later
import type { Solid } from "./core";

const vertexShader = `#version 300 es
layout(location = 0) in vec3 seen;
layout(location = 1) in vec4 colour;
layout(location = 2) in float lit;
uniform mat4 clip;
out vec3 at;
flat out vec4 ink;
flat out float shaded;
void main() {
  gl_Position = clip * vec4(seen, 1.0);
  at = seen;
  ink = colour;
  shaded = lit;
}`;
const fragmentShader = `#version 300 es
precision highp float;
in vec3 at;
flat in vec4 ink;
flat in float shaded;
uniform vec3 forward, lamp;
out vec4 result;
void main() {
  float shade = 1.0;
  vec3 n = cross(dFdx(at), dFdy(at));
  float size = dot(n, n);
  if (shaded > 0.5 && size > 0.0) {
    n *= inversesqrt(size);
    if (dot(n, at) > 0.0) n = -n;
    shade = 0.3 + 0.14 * abs(dot(n, forward)) + 0.56 * (0.5 + 0.5 * dot(n, lamp));
  }
  result = vec4(ink.rgb * shade * ink.a, ink.a);
}`;
const cornerBytes = 20;

export class SolidCanvas {
  readonly element = document.createElement("canvas");
  private readonly gl: WebGL2RenderingContext;
  private readonly program: WebGLProgram;

  constructor() {
    const gl = this.element.getContext("webgl2", { antialias: true, preserveDrawingBuffer: true, alpha: false });
    if (!gl) throw new Error("this browser shows nothing in three dimensions: it has no WebGL 2");
    this.gl = gl;
    this.program = gl.createProgram()!;
    for (const [kind, text] of [[gl.VERTEX_SHADER, vertexShader], [gl.FRAGMENT_SHADER, fragmentShader]] as const) {
      const shader = gl.createShader(kind)!;
      gl.shaderSource(shader, text);
      gl.compileShader(shader);
      if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS)) throw new Error(gl.getShaderInfoLog(shader) ?? "shader");
      gl.attachShader(this.program, shader);
    }
    gl.linkProgram(this.program);
    gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
    gl.vertexAttribPointer(0, 3, gl.FLOAT, false, cornerBytes, 0);
    gl.vertexAttribPointer(1, 4, gl.UNSIGNED_BYTE, true, cornerBytes, 12);
    gl.vertexAttribPointer(2, 1, gl.FLOAT, false, cornerBytes, 16);
    for (const i of [0, 1, 2]) gl.enableVertexAttribArray(i);
  }

  draw(solid: Solid, memory: ArrayBufferLike, width: number, height: number) {
    const { gl } = this;
    if (this.element.width !== width || this.element.height !== height) {
      this.element.width = width;
      this.element.height = height;
    }
    gl.viewport(0, 0, width, height);
    const at = (k: number) => parseInt(solid.background.slice(1 + 2 * k, 3 + 2 * k), 16) / 255;
    gl.clearColor(at(0), at(1), at(2), 1);
    gl.depthMask(true);
    gl.clearDepth(0);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.GEQUAL);
    gl.useProgram(this.program);
    const place = (name: string) => gl.getUniformLocation(this.program, name);
    gl.uniformMatrix4fv(place("clip"), false, solid.clip);
    gl.uniform3fv(place("forward"), solid.forward);
    gl.uniform3fv(place("lamp"), solid.lamp);
    const upload = (from: number, corners: number) => {
      const bytes = new Uint8Array(memory as ArrayBuffer, from, corners * cornerBytes);
      gl.bufferData(gl.ARRAY_BUFFER, bytes, gl.DYNAMIC_DRAW);
    };
    if (solid.triangleCorners > 0) {
      upload(solid.triangles, solid.triangleCorners);
      gl.disable(gl.BLEND);
      gl.enable(gl.POLYGON_OFFSET_FILL);
      gl.polygonOffset(-1, -1);
      gl.drawArrays(gl.TRIANGLES, 0, solid.opaque);
      gl.disable(gl.POLYGON_OFFSET_FILL);
      if (solid.triangleCorners > solid.opaque) {
        gl.enable(gl.BLEND);
        gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
        gl.depthMask(false);
        gl.drawArrays(gl.TRIANGLES, solid.opaque, solid.triangleCorners - solid.opaque);
        gl.depthMask(true);
      }
    }
    if (solid.edgeCorners > 0) {
      upload(solid.edges, solid.edgeCorners);
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
      gl.drawArrays(gl.LINES, 0, solid.edgeCorners);
    }
  }
}
