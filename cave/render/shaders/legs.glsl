// What the kernels need to know of their surroundings, as GLSL. Legs lie in a texture buffer, fifteen texels
// each, in the order of LegView's members; the table of shifted colours in another.
#define real float
#define KERNEL
#define LEGS int
#define COLOUR_TABLE int
#ifndef MAX_PIECES
#define MAX_PIECES 8
#endif
uniform samplerBuffer colourTexels;
