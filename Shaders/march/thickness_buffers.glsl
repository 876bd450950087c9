// Thickness, in scalar opacity unit distances, of a unit of depth along a direction; bound by GL/ThicknessBinding.
uniform mat3 thicknessMatrix; // direction -> scalar opacity unit distances

float thicknessPerDepthAlong(vec3 direction) { return length(thicknessMatrix * direction); }
