"""Kimura, Ogata, Ishii: a sphere driven by two constraint rollers, with slip."""
