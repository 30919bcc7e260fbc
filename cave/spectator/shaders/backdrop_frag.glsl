// Behind everything: darker below, so that the walls shine.
#version 150
in vec2 place;
out vec4 colour;

void main() { colour = vec4(mix(vec3(0.11, 0.12, 0.15), vec3(0.24, 0.27, 0.33), place.y), 1.0); }
