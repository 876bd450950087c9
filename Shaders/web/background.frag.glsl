// The background of a picture: one colour, or a gradient from bottom to top.
//VTK::Output::Dec

uniform vec4 viewport; // x, y, width, height in pixels
uniform vec3 lowColor;
uniform vec3 highColor;

void main() { gl_FragData[0] = vec4(mix(lowColor, highColor, (gl_FragCoord.y - viewport.y) / viewport.w), 1.0); }
