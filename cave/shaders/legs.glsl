// What the emission kernel needs to know of its surroundings, as GLSL. Legs lie in a texture buffer, fourteen
// texels each, in the order of LegView's members.
#define real float
#define KERNEL
#define LEGS int
#ifndef MAX_PIECES
#define MAX_PIECES 8
#endif
uniform samplerBuffer legTexels;
