// The GLSL definitions that the kernels need. A texture buffer holds the legs, seventeen texels each, in the
// order of the members of LegView; another holds the table of shifted colours.
#define real float
#define KERNEL
#define INOUT(type) inout type
#define UNROLLED
#define LEGS int
#define LEG LegView
#define COLOUR_TABLE int
#ifndef MAX_PIECES
#define MAX_PIECES 8
#endif
uniform samplerBuffer colourTexels;
