// A point of an opaque surface.
#include "language.glsl"

layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 color;
layout(location = 3) in vec2 tableCoordinate;

uniform mat4 dataToView;
uniform mat4 dataToClip;
uniform mat3 normalToView;

out vec3 viewPosition;
out vec3 viewNormal;
out vec4 pointColor;
out vec2 pointInTable;

void main()
{
  viewPosition = vec3(dataToView * vec4(position, 1.0));
  viewNormal = normalToView * normal;
  pointColor = color;
  pointInTable = tableCoordinate;
  gl_Position = dataToClip * vec4(position, 1.0);
}
