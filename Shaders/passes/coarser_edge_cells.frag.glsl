// The cells of twice the size (passes/edge_cells.frag.glsl).
//VTK::Output::Dec

uniform sampler2D edgeTexture; // of the smaller cells
uniform ivec2 lastCell;        // of them

float edgeAt(ivec2 at) { return texelFetch(edgeTexture, min(at, lastCell), 0).x; }

void main()
{
  ivec2 at = 2 * ivec2(gl_FragCoord.xy);
  float edge = max(max(edgeAt(at), edgeAt(at + ivec2(1, 0))), max(edgeAt(at + ivec2(0, 1)), edgeAt(at + ivec2(1, 1))));
  gl_FragData[0] = vec4(edge, 0.0, 0.0, 0.0);
}
