// Attributes of a vertex besides its position and its first scalar.
#if TETMARCH_VERTEX_ATTRIBUTES
struct VertexAttributes
{
#if TETMARCH_VERTEX_GRADIENTS
  vec3 gradient; // of the scalar
#endif
#if TETMARCH_COMPONENT_GRADIENTS
  vec3 gradientA; // of each independent component
  vec3 gradientB;
  vec3 gradientC;
  vec3 gradientD;
#endif
#if TETMARCH_VERTEX_LIGHT
  vec4 light; // transmittance towards ambient light and towards up to three lights that cast shadows
#endif
#if TETMARCH_EXTRA_VERTEX_SCALARS
  vec3 extra; // extra scalars
#endif
};

#if TETMARCH_COMPONENT_GRADIENTS
// Of any component if there are fewer.
vec3 fetchComponentGradient(uint vertex, int component)
{
  return fetchGradient(vertex * uint(componentCount) + uint(min(component, componentCount - 1)));
}

vec3 componentGradient(VertexAttributes attributes, int component)
{
  return component == 0   ? attributes.gradientA
         : component == 1 ? attributes.gradientB
         : component == 2 ? attributes.gradientC
                          : attributes.gradientD;
}
#endif

VertexAttributes fetchAttributes(uint vertex)
{
  VertexAttributes attributes;
#if TETMARCH_VERTEX_GRADIENTS
  attributes.gradient = fetchGradient(vertex);
#endif
#if TETMARCH_COMPONENT_GRADIENTS
  attributes.gradientA = fetchComponentGradient(vertex, 0);
  attributes.gradientB = fetchComponentGradient(vertex, 1);
  attributes.gradientC = fetchComponentGradient(vertex, 2);
  attributes.gradientD = fetchComponentGradient(vertex, 3);
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
#if TETMARCH_COMPONENT_GRADIENTS
  second.gradientA = condition ? first.gradientA : second.gradientA;
  second.gradientB = condition ? first.gradientB : second.gradientB;
  second.gradientC = condition ? first.gradientC : second.gradientC;
  second.gradientD = condition ? first.gradientD : second.gradientD;
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
#if TETMARCH_COMPONENT_GRADIENTS
  a.gradientA = a.gradientA * barycentrics.x + b.gradientA * barycentrics.y + c.gradientA * barycentrics.z;
  a.gradientB = a.gradientB * barycentrics.x + b.gradientB * barycentrics.y + c.gradientB * barycentrics.z;
  a.gradientC = a.gradientC * barycentrics.x + b.gradientC * barycentrics.y + c.gradientC * barycentrics.z;
  a.gradientD = a.gradientD * barycentrics.x + b.gradientD * barycentrics.y + c.gradientD * barycentrics.z;
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
