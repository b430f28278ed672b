"""Simulation: the models of all papers as pictures, and what was measured on them."""
