// SPDX-FileCopyrightText: Copyright (c) 2026, the TetMarch authors
// SPDX-License-Identifier: BSD-3-Clause
// Framebuffers that a picture is drawn into.

export class Target
{
  /** formats: of the colours, such as "RGBA8"; depth: with a texture of depths. */
  constructor(gl, formats, depth = false)
  {
    this.gl = gl;
    this.formats = formats;
    this.hasDepth = depth;
    this.size = [0, 0];
    this.colors = [];
  }

  resize(width, height)
  {
    if (this.size[0] === width && this.size[1] === height)
    {
      return;
    }
    this.release();
    const gl = this.gl;
    this.size = [width, height];
    this.framebuffer = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    this.colors = this.formats.map((format, i) => this.attach(format, gl.COLOR_ATTACHMENT0 + i));
    this.depth = this.hasDepth ? this.attach("DEPTH_COMPONENT24", gl.DEPTH_ATTACHMENT) : null;
    gl.drawBuffers(this.formats.map((_, i) => gl.COLOR_ATTACHMENT0 + i));
    if (gl.checkFramebufferStatus(gl.FRAMEBUFFER) !== gl.FRAMEBUFFER_COMPLETE &&
        !gl.isContextLost())
    {
      throw new Error(
        `This browser's graphics can't draw a picture of ${width} x ${height} pixels ` +
        `of the format ${this.formats[0]}. Make the window smaller, or try another browser.`);
    }
  }

  attach(format, attachment)
  {
    const gl = this.gl;
    const texture = gl.createTexture();
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    const filter = format === "RGBA8" ? gl.LINEAR : gl.NEAREST;
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, filter);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_S, gl.CLAMP_TO_EDGE);
    gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_WRAP_T, gl.CLAMP_TO_EDGE);
    gl.texStorage2D(gl.TEXTURE_2D, 1, gl[format], ...this.size);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, attachment, gl.TEXTURE_2D, texture, 0);
    return {target: gl.TEXTURE_2D, texture};
  }

  bind()
  {
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, this.framebuffer);
    this.gl.viewport(0, 0, ...this.size);
  }

  clear()
  {
    const gl = this.gl;
    this.formats.forEach((_, i) => gl.clearBufferfv(gl.COLOR, i, [0, 0, 0, 0]));
    if (this.hasDepth)
    {
      gl.depthMask(true);
      gl.clearBufferfv(gl.DEPTH, 0, [1]);
    }
  }

  /** Copies its first colour to a framebuffer of the same size (null: the canvas). */
  copyTo(framebuffer)
  {
    const gl = this.gl;
    const [width, height] = this.size;
    gl.bindFramebuffer(gl.READ_FRAMEBUFFER, this.framebuffer);
    gl.bindFramebuffer(gl.DRAW_FRAMEBUFFER, framebuffer);
    gl.blitFramebuffer(0, 0, width, height, 0, 0, width, height, gl.COLOR_BUFFER_BIT, gl.NEAREST);
  }

  /** The numbers of an attachment of floats in a rectangle, four a pixel, rows from the bottom. */
  read(attachment, rectangle)
  {
    const [x, y, width, height] = rectangle;
    const gl = this.gl;
    const pixels = new Float32Array(4 * width * height);
    gl.bindFramebuffer(gl.FRAMEBUFFER, this.framebuffer);
    gl.readBuffer(gl.COLOR_ATTACHMENT0 + attachment);
    gl.readPixels(x, y, width, height, gl.RGBA, gl.FLOAT, pixels);
    return pixels;
  }

  release()
  {
    const gl = this.gl;
    [...this.colors, ...(this.depth ? [this.depth] : [])].forEach(
      ({texture}) => gl.deleteTexture(texture));
    gl.deleteFramebuffer(this.framebuffer || null);
    this.colors = [];
    this.size = [0, 0];
  }
}
