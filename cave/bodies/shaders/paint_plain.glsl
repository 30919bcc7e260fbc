Painted paint() { return Painted(colour, vec3(0.0), 1.0); }
