"""Kimura, Shigyo, Ishii (2023): roller arrangement and speed efficiency."""
