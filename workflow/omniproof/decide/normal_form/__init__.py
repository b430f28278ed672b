"""A formula in the normal form of a quotient ring, by FLINT: the engine that proves."""
