// Attributes of a vertex besides its position and its first scalar.
#if TETMARCH_VERTEX_ATTRIBUTES
struct VertexAttributes
{
#if TETMARCH_VERTEX_GRADIENTS
  vec3 gradient; // of the scalar
#endif
#if TETMARCH_VERTEX_LIGHT
  vec4 light; // transmittance towards ambient light and towards up to three lights that cast shadows
#endif
#if TETMARCH_EXTRA_VERTEX_SCALARS
  vec3 extra; // extra scalars
#endif
};

VertexAttributes fetchAttributes(uint vertex)
{
  VertexAttributes attributes;
#if TETMARCH_VERTEX_GRADIENTS
  attributes.gradient = fetchGradient(vertex);
#endif
#if TETMARCH_VERTEX_LIGHT
  attributes.light = fetchVertexLight(vertex);
#endif
#if TETMARCH_EXTRA_VERTEX_SCALARS
  attributes.extra = fetchExtraScalars(vertex);
#endif
  return attributes;
}

// The first attributes if the condition holds, else the second ones.
VertexAttributes selectAttributes(bool condition, VertexAttributes first, VertexAttributes second)
{
#if TETMARCH_VERTEX_GRADIENTS
  second.gradient = condition ? first.gradient : second.gradient;
#endif
#if TETMARCH_VERTEX_LIGHT
  second.light = condition ? first.light : second.light;
#endif
#if TETMARCH_EXTRA_VERTEX_SCALARS
  second.extra = condition ? first.extra : second.extra;
#endif
  return second;
}

VertexAttributes interpolateAttributes(VertexAttributes a, VertexAttributes b, VertexAttributes c, vec3 barycentrics)
{
#if TETMARCH_VERTEX_GRADIENTS
  a.gradient = a.gradient * barycentrics.x + b.gradient * barycentrics.y + c.gradient * barycentrics.z;
#endif
#if TETMARCH_VERTEX_LIGHT
  a.light = a.light * barycentrics.x + b.light * barycentrics.y + c.light * barycentrics.z;
#endif
#if TETMARCH_EXTRA_VERTEX_SCALARS
  a.extra = a.extra * barycentrics.x + b.extra * barycentrics.y + c.extra * barycentrics.z;
#endif
  return a;
}
#endif
