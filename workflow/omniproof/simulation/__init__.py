"""Experiments in an open physics engine: models built from parameters, no result known beforehand.

Nothing of the kinematics enters a model: bodies, hinges, contacts and friction do, and what moves
follows from them. The kinematics is what the recordings are compared with.
"""
