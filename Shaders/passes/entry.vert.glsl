// Draws the boundary faces: three vertices each, fetched by number.
uniform samplerBuffer vertexBuffer;
uniform usamplerBuffer boundaryBuffer;
uniform mat4 normalizedToClip;

flat out float face;
out vec3 barycentrics; // perspective-correct

void main()
{
  int number = gl_VertexID / 3;
  int corner = gl_VertexID - 3 * number;
  uvec4 ids = texelFetch(boundaryBuffer, number);
  uint id = corner == 0 ? ids.x : (corner == 1 ? ids.y : ids.z);
  face = float(number);
  barycentrics = vec3(corner == 0 ? 1.0 : 0.0, corner == 1 ? 1.0 : 0.0, corner == 2 ? 1.0 : 0.0);
  gl_Position = normalizedToClip * vec4(texelFetch(vertexBuffer, int(id)).xyz, 1.0);
}
