// The volume's reflection of a light.
vec3 reflection(vec4 mean, Light light) { return emission(mean) * light.diffuse + light.specular * mean.w; }
