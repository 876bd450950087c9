// Window and level of the final colours. A premultiplied colour is mapped like the colour itself.

uniform vec2 colorWindow; // a factor, and the offset of an opaque colour

vec4 windowed(vec4 color) { return vec4(colorWindow.x * color.rgb + colorWindow.y * color.a, color.a); }
