// Window and level of the final colours. A premultiplied colour is mapped as the colour itself would be.

uniform vec2 colorWindow; // a factor, and what is added to an opaque colour

vec4 windowed(vec4 color) { return vec4(colorWindow.x * color.rgb + colorWindow.y * color.a, color.a); }
