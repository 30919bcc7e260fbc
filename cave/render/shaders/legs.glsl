// What the kernels need to know of their surroundings, as GLSL. Legs lie in a texture buffer, sixteen texels
// each, in the order of LegView's members; the table of shifted colours in another.
#define real float
#define KERNEL
#define UNROLLED
#define LEGS int
#define COLOUR_TABLE int
#ifndef MAX_PIECES
#define MAX_PIECES 8
#endif
uniform samplerBuffer colourTexels;
