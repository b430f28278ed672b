"""Kimura, Ogata, Hirai, Ueda, Ishii: a sphere on three rollers that may slip."""
