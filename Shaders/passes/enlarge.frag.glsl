// A picture of fewer pixels, enlarged to the viewport.
//VTK::Output::Dec

uniform vec4 viewport; // x, y, width, height in pixels
uniform sampler2D pictureTexture;

void main() { gl_FragData[0] = texture(pictureTexture, (gl_FragCoord.xy - viewport.xy) / viewport.zw); }
