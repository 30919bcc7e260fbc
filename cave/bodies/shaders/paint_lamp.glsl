Painted paint() { return Painted(vec3(0.0), colour, 1.0); }
