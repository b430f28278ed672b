# ruff: noqa: E501 - a printed line stays one line
"""Real lines: each display, as printed, against the same formula written in plain Python.

The right-hand column repeats what the paper prints, misprints included: this is a test of the
reader, not of the papers.
"""

from __future__ import annotations

from math import cos, pi, radians, sin, sqrt
from typing import Any

import numpy as np
import pytest
from sympy import ImmutableMatrix, MatrixBase, Rational, Symbol, symbols

from omniproof.formula.evaluation import Function, evaluate
from omniproof.transcription.model import Notation
from omniproof.transcription.reader import read
from omniproof.transcription.symbols import symbol_name
from omniproof.transcription.tree import Applied, walk
from omniproof.transcription.verbatim import sources_folder

POINT = {
    r"\alpha_1": "2/7", r"\alpha_2": "1", r"\alpha_3": "9/4", r"\alpha_k": "5/9",
    r"\theta": "3/8", r"\theta_1": "1/3", r"\theta_2": "6/5", r"\theta_3": "8/7", "L": "3/2", "R": "4/7",
    "V_x": "5/4", "V_y": "-2/3", r"\dot{\phi}": "7/9", "v_1": "1/5", "v_2": "-3/4", "v_3": "6/7",
    "v_k": "5/6", "v_k^T": "1/7", "v_k^R": "2/9", "A": "4/3", "B": "5/2", "C": "7/3", "V": "8/5",
    r"\det A": "11/9", "D_V": "13/4", "D_A": "5/3", r"\overline{OH}": "3/7",
    **{rf"\widetilde{{a}}_{{{i},{k}}}": f"{3 * i + k}/{i + 2 * k}"
       for i in (1, 2, 3) for k in (1, 2, 3)},
    r"\phi": "4/5", "r": "2/5", r"\psi": "5/7", "a": "1/2", "b": "-1/3", "c": "5/4",
    r"\nu_1": "1/6", r"\nu_2": "5/8", r"\nu_3": "-3/2", r"\omega_1": "2", r"\omega_2": "-1/2",
    r"\omega_3": "3/4", r"\dot{X}_m": "1/9", r"\dot{Y}_m": "7/8", r"\dot{X}_W": "-2/9",
    r"\dot{Y}_W": "5/8", r"\delta_x": "1/8", r"\delta_y": "3/8", r"\delta_z": "-5/8", "d_x": "1/7",
    "d_y": "-2/7", "d_z": "3/7", r"\delta_z^B": "2/3", "d_x^B": "1/4", "d_y^B": "-6/5",
    r"\omega_z^B": "3/2", "v_x^B": "7/4", "v_y^B": "-1/4", "v_y^{C_1}": "1", "v_y^{C_2}": "2",
    r"\psi_i": "2/3", r"\theta_{1,i}": "5/6", r"\theta_{2,i}": "1/4", "v_i": "9/8",
    "D_2": "2", "D_3": "3", "D_5": "5", "D_8": "8", "D_9": "9", "D_{10}": "10", "E_3": "1/3",
    "E_9": "2/9", "C_1": "7", "C_4": "1/4", "C_6": "6/5", "C_7": "7/2", "d_1": "2", "d_2": "3",
    "d_3": "1/2", "z_0": "7", "y_0": "1/4", "x_0": "7/2",
}  # fmt: skip
VECTORS = {
    "n_k": ["2/3", "-1/5"], "q_i": ["1/3", "4"], "q_1": ["1", "2"],
    "a_1": ["1", "1/2", "-2"], "a_2": ["3/4", "-1", "5"], "a_3": ["2", "1/3", "1"],
    r"\hat{a}_1": ["1", "1/2", "0"], r"\hat{a}_2": ["3/4", "-1", "0"], r"\hat{a}_3": ["-2", "1/3", "0"],
    r"\eta_i": ["1/2", "2/3", "-1/6"], r"\omega": ["1", "-1/2", "4"], "X_i": ["1", "2", "0"],
    "Y_i": ["0", "1/2", "3"], "P_i": ["1/4", "1", "-1"], "Q": ["2", "0", "1/3"],
    r"\bar{n}": ["1/3", "2/3", "2/3"], r"\bar{o}": ["0", "1", "2"], r"\bar{a}": ["1", "0", "5"],
    r"\bar{p}": ["1", "-1", "2"], r"\bar{\delta}^B": ["1/2", "1/3", "1/4"],
    r"\bar{d}^B": ["3", "-1", "1/2"],
}  # fmt: skip
MEANINGS: dict[str, Any] = {
    **{name: Rational(value) for name, value in POINT.items()},
    **{
        name: ImmutableMatrix([Rational(entry) for entry in value])
        for name, value in VECTORS.items()
    },
}


def number(name: str) -> float:
    return float(Rational(POINT[name]))


def vector(name: str) -> Any:
    return np.array([float(Rational(entry)) for entry in VECTORS[name]])


a1, a2, a3, ak, th, th1 = (
    number(n) for n in (r"\alpha_1", r"\alpha_2", r"\alpha_3", r"\alpha_k", r"\theta", r"\theta_1")
)
L, VX, VY, PHI_DOT, DET = (number(n) for n in ("L", "V_x", "V_y", r"\dot{\phi}", r"\det A"))
A, B, C, V = (number(n) for n in "ABCV")
V1, V2, V3 = (number(f"v_{k}") for k in (1, 2, 3))
VEC = {name: vector(name) for name in VECTORS}
E1, E2, E3 = VEC["a_1"], VEC["a_2"], VEC["a_3"]
H1, H2, H3 = VEC[r"\hat{a}_1"], VEC[r"\hat{a}_2"], VEC[r"\hat{a}_3"]
ADJUGATE = [[number(rf"\widetilde{{a}}_{{{i},{k}}}") for k in (1, 2, 3)] for i in (1, 2, 3)]
NORM = np.linalg.norm
PHI, DZ = number(r"\phi"), number(r"\delta_z^B")
WHEELS = [[-sin(x), cos(x), 1] for x in (a1, a2, a3)]
COFACTORS = [
    [cos(a2) - cos(a3), -cos(a1) + cos(a3), cos(a1) - cos(a2)],
    [sin(a2) - sin(a3), -sin(a1) + sin(a3), sin(a1) + sin(a2)],
    [-sin(a2 - a3), -sin(a3 - a1), -sin(a1 - a2)],
]
COLUMNS = np.array(COFACTORS).T / DET
PLANAR = COLUMNS * [1, 1, 0]
TWIST = [VX, VY, L * PHI_DOT]
SPEEDS = [V1, V2, V3]
Z23, Z13 = np.cross(E2, E3)[2], np.cross(E1, E3)[2]
HZ = np.cross(H2, H3)[2] * np.cross(H1, H3)[2]

ARRANGEMENT = [
    pytest.param(r"\mathbf{q}_i = L(\cos \alpha_k, \sin \alpha_k)^T \quad (1)",
                 (VEC["q_i"], [L * cos(ak), L * sin(ak)]), id="1"),
    pytest.param(r"\mathbf{n}_k = (-\sin \alpha_k, \cos \alpha_k)^T \quad (2)",
                 (VEC["n_k"], [-sin(ak), cos(ak)]), id="2"),
    pytest.param(r"v_k = v_k^T + v_k^R \quad (3)", (5 / 6, 1 / 7 + 2 / 9), id="3"),
    pytest.param(r"= \langle \mathbf{n}_k, (V_x, V_y)^T \rangle + L\dot{\phi} \quad (4)",
                 (VEC["n_k"] @ [VX, VY] + L * PHI_DOT,), id="4"),
    pytest.param(r"\begin{pmatrix} v_1 \\ v_2 \\ v_3 \end{pmatrix} = \begin{pmatrix} -\sin \alpha_1 & \cos \alpha_1 & 1 \\ -\sin \alpha_2 & \cos \alpha_2 & 1 \\ -\sin \alpha_3 & \cos \alpha_3 & 1 \end{pmatrix} \begin{pmatrix} V_x \\ V_y \\ L\dot{\phi} \end{pmatrix} \quad (5)",
                 (SPEEDS, np.array(WHEELS) @ TWIST), id="5"),
    pytest.param(r"\begin{pmatrix} V_x \\ V_y \\ L\dot{\phi} \end{pmatrix} = (\det \mathbf{A})^{-1} \begin{pmatrix} \cos \alpha_2 - \cos \alpha_3 & -\cos \alpha_1 + \cos \alpha_3 & \cos \alpha_1 - \cos \alpha_2 \\ \sin \alpha_2 - \sin \alpha_3 & -\sin \alpha_1 + \sin \alpha_3 & \sin \alpha_1 + \sin \alpha_2 \\ -\sin(\alpha_2 - \alpha_3) & -\sin(\alpha_3 - \alpha_1) & -\sin(\alpha_1 - \alpha_2) \end{pmatrix} \begin{pmatrix} v_1 \\ v_2 \\ v_3 \end{pmatrix}",
                 (TWIST, np.array(COFACTORS) @ SPEEDS / DET), id="6, two displays"),
    pytest.param(r"\det \mathbf{A} = -\sin(\alpha_1 - \alpha_2) - \sin(\alpha_2 - \alpha_3) - \sin(\alpha_3 - \alpha_1) \quad (7)",
                 (DET, -sin(a1 - a2) - sin(a2 - a3) - sin(a3 - a1)), id="7"),
    pytest.param(r"\{(v_1, v_2, v_3) \mid |v_1|, |v_2|, |v_3| \leq 1\}",
                 (SPEEDS, True, True, True), id="8, right side"),
    pytest.param(r"\{(V_x, V_y, L\dot{\phi}) \mid v_1 \mathbf{a}_1 + v_2 \mathbf{a}_2 + v_3 \mathbf{a}_3, |v_1|, |v_2|, |v_3| \leq 1\}",
                 (TWIST, V1 * E1 + V2 * E2 + V3 * E3, True, True, True), id="9, right side"),
    pytest.param(r"\begin{aligned} \mathbf{a}_1 &= (\det \mathbf{A})^{-1} \begin{pmatrix} \cos \alpha_2 - \cos \alpha_3 \\ \sin \alpha_2 - \sin \alpha_3 \\ -\sin(\alpha_2 - \alpha_3) \end{pmatrix}, \\ \mathbf{a}_2 &= (\det \mathbf{A})^{-1} \begin{pmatrix} -\cos \alpha_1 + \cos \alpha_3 \\ -\sin \alpha_1 + \sin \alpha_3 \\ -\sin(\alpha_3 - \alpha_1) \end{pmatrix}, \\ \mathbf{a}_3 &= (\det \mathbf{A})^{-1} \begin{pmatrix} \cos \alpha_1 - \cos \alpha_2 \\ \sin \alpha_1 + \sin \alpha_2 \\ -\sin(\alpha_1 - \alpha_2) \end{pmatrix} \end{aligned} \quad (10)",
                 tuple(zip((E1, E2, E3), COLUMNS, strict=True)), id="10"),
    pytest.param(r"D_V(\theta_1, \theta_2, \theta_3) = 8 / \det \mathbf{A} \text{ [m/s]}^3 \quad (11)",
                 (13 / 4, 8 / DET), id="11"),
    pytest.param(r"D_V(\theta) = \frac{8}{2 \cos \theta + \sin 2\theta} \quad (12)",
                 (13 / 4, 8 / (2 * cos(th) + sin(2 * th))), id="12"),
    pytest.param(r"\{(V_x, V_y) \mid v_1 \hat{\mathbf{a}}_1 + v_2 \hat{\mathbf{a}}_2 + v_3 \hat{\mathbf{a}}_3, |v_1|, |v_2|, |v_3| \leq 1\}",
                 ([VX, VY], V1 * H1 + V2 * H2 + V3 * H3, True, True, True), id="13, right side"),
    pytest.param(r"\begin{aligned} \hat{\mathbf{a}}_1 &= (\det \mathbf{A})^{-1} \begin{pmatrix} \cos \alpha_2 - \cos \alpha_3 \\ \sin \alpha_2 - \sin \alpha_3 \\ 0 \end{pmatrix} \\ \hat{\mathbf{a}}_2 &= (\det \mathbf{A})^{-1} \begin{pmatrix} -\cos \alpha_1 + \cos \alpha_3 \\ -\sin \alpha_1 + \sin \alpha_3 \\ 0 \end{pmatrix} \\ \hat{\mathbf{a}}_3 &= (\det \mathbf{A})^{-1} \begin{pmatrix} \cos \alpha_1 - \cos \alpha_2 \\ \sin \alpha_1 + \sin \alpha_2 \\ 0 \end{pmatrix} \end{aligned} \quad (14)",
                 tuple(zip((H1, H2, H3), PLANAR, strict=True)), id="14"),
    pytest.param(r"D_A = \begin{cases} 4\|\hat{\mathbf{a}}_1 \times \hat{\mathbf{a}}_2\| + 4\|(\hat{\mathbf{a}}_1 - \hat{\mathbf{a}}_2) \times \hat{\mathbf{a}}_3\| \\ \quad [(\hat{\mathbf{a}}_2 \times \hat{\mathbf{a}}_3)_z (\hat{\mathbf{a}}_1 \times \hat{\mathbf{a}}_3)_z < 0] \\ 4\|\hat{\mathbf{a}}_1 \times \hat{\mathbf{a}}_2\| + 4\|(\hat{\mathbf{a}}_1 + \hat{\mathbf{a}}_2) \times \hat{\mathbf{a}}_3\| \\ \quad [(\hat{\mathbf{a}}_2 \times \hat{\mathbf{a}}_3)_z (\hat{\mathbf{a}}_1 \times \hat{\mathbf{a}}_3)_z > 0] \end{cases} \quad (15)",
                 (5 / 3, 4 * NORM(np.cross(H1, H2)) + 4 * NORM(np.cross(
                     H1 - H2 if HZ < 0 else H1 + H2, H3))), id="15"),
    pytest.param(r"\frac{1}{\det A} \begin{bmatrix} \widetilde{a}_{1,1} & \widetilde{a}_{1,2} & \widetilde{a}_{1,3} \\ \widetilde{a}_{2,1} & \widetilde{a}_{2,2} & \widetilde{a}_{2,3} \\ \widetilde{a}_{3,1} & \widetilde{a}_{3,2} & \widetilde{a}_{3,3} \end{bmatrix} \quad (A,1)",
                 np.array(ADJUGATE) / DET, id="A.1"),
    pytest.param(r"\begin{aligned} \widetilde{a}_{1,1} &= L \cos \alpha_2 - L \cos \alpha_3 \\ \widetilde{a}_{2,2} &= -L \sin \alpha_1 + L \sin \alpha_1 \\ \widetilde{a}_{1,2} &= -L \cos \alpha_1 + L \cos \alpha_3 \\ \widetilde{a}_{2,1} &= L \sin \alpha_2 - L \sin \alpha_3 \\ \widetilde{a}_{1,3} &= L \cos \alpha_1 - L \cos \theta_1 \\ \widetilde{a}_{2,3} &= L \sin \alpha_1 - L \sin \alpha_2 \end{aligned} \quad (A,2)",
                 ((ADJUGATE[0][0], L * cos(a2) - L * cos(a3)), (ADJUGATE[1][1], 0),
                  (ADJUGATE[0][1], L * cos(a3) - L * cos(a1)),
                  (ADJUGATE[1][0], L * sin(a2) - L * sin(a3)),
                  (ADJUGATE[0][2], L * cos(a1) - L * cos(th1)),
                  (ADJUGATE[1][2], L * sin(a1) - L * sin(a2))), id="A.2"),
    pytest.param(r"\det A = \widetilde{a}_{3,1} + \widetilde{a}_{3,2} + \widetilde{a}_{3,3} \quad (A,3)",
                 (DET, sum(ADJUGATE[2])), id="A.3"),
    pytest.param(r"\begin{aligned} \widetilde{a}_{3,1} &= -\sin \alpha_2 \cos \alpha_3 + \cos \alpha_2 \sin \alpha_3 \\ &= -\sin(\alpha_2 - \alpha_3) \\ \widetilde{a}_{3,2} &= \sin \alpha_1 \cos \alpha_3 - \cos \alpha_1 \sin \alpha_3 \\ &= \sin(\alpha_1 - \alpha_3) \\ \widetilde{a}_{3,3} &= -\sin \alpha_1 \cos \alpha_2 + \cos \alpha_1 \sin \alpha_2 \\ &= \sin(\alpha_2 - \alpha_1) \end{aligned} \quad (A,4)",
                 ((ADJUGATE[2][0], sin(a3 - a2), sin(a3 - a2)),
                  (ADJUGATE[2][1], sin(a1 - a3), sin(a1 - a3)),
                  (ADJUGATE[2][2], sin(a2 - a1), sin(a2 - a1))), id="A.4"),
    pytest.param(r"\overline{OH} = \frac{1}{\|\mathbf{a}_1 \times \mathbf{a}_2\|} \langle \mathbf{a}_1 \times \mathbf{a}_2, \mathbf{a}_3 \rangle \quad (B,2)",
                 (3 / 7, np.cross(E1, E2) @ E3 / NORM(np.cross(E1, E2))), id="B.2"),
    pytest.param(r"\mathbf{V} = \|\mathbf{a}_1 \times \mathbf{a}_2\| \times \overline{\mathbf{OH}} \quad (\text{B},3)",
                 (V, NORM(np.cross(E1, E2)) * 3 / 7), id="B.3"),
    pytest.param(r"\mathbf{V} = \langle \mathbf{a}_1 \times \mathbf{a}_2, \mathbf{a}_3 \rangle = \det[\mathbf{a}_1, \mathbf{a}_2, \mathbf{a}_3] \quad (\text{B},3)",
                 (V, np.cross(E1, E2) @ E3, np.linalg.det([E1, E2, E3])), id="B.3#2"),
    pytest.param(r"\alpha_2 - \alpha_1 = A, \alpha_3 - \alpha_2 = B, C = 360^\circ - A - B \quad (\text{C},4)",
                 ((a2 - a1, A), (a3 - a2, B), (C, 2 * pi - A - B)), id="C.4"),
    pytest.param(r"\sin(\alpha_1 - \alpha_3) = \sin(C - 360^\circ) = \sin C \quad (\text{C},5)",
                 (sin(a1 - a3), sin(C), sin(C)), id="C.5"),
    pytest.param(r"\det \mathbf{A} = L(\sin A + \sin B + \sin C) \quad (\text{C},6)",
                 (DET, L * (sin(A) + sin(B) + sin(C))), id="C.6"),
    pytest.param(r"(A + B + C = 360^\circ)", (A + B + C, 2 * pi), id="C.6, its condition"),
    pytest.param(r"\{v_1 \mathbf{a}_1 + v_2 \mathbf{a}_2 \mid |v_1|, |v_2| \leq 1\} \quad (\text{D},1)",
                 (V1 * E1 + V2 * E2, True, True), id="D.1, right side"),
    pytest.param(r"\{(\mathbf{a}_2 \times \mathbf{a}_3)_z < 0 \text{ and } (\mathbf{a}_1 \times \mathbf{a}_3)_z > 0\} \text{or } \{(\mathbf{a}_2 \times \mathbf{a}_3)_z > 0 \text{ and } (\mathbf{a}_1 \times \mathbf{a}_3)_z < 0\} \quad (\text{D},2)",
                 (Z23 < 0 < Z13) or (Z13 < 0 < Z23), id="D.2, two displays"),
    pytest.param(r"\Leftrightarrow (\mathbf{a}_2 \times \mathbf{a}_3)_z (\mathbf{a}_1 \times \mathbf{a}_3)_z < 0 \quad (\text{D},3)",
                 (Z23 * Z13 < 0,), id="D.3"),
    pytest.param(r"\{\alpha_1, \alpha_2, \alpha_3\} = \{30^\circ, 150^\circ, 270^\circ\}",
                 ((a1, a2, a3), (pi / 6, 5 * pi / 6, 3 * pi / 2)), id="Type (X)"),
]  # fmt: skip

NU1, NU2, NU3 = (number(rf"\nu_{k}") for k in (1, 2, 3))
a, b, c = (number(n) for n in "abc")
XM, YM = number(r"\dot{X}_m"), number(r"\dot{Y}_m")
CROSS = np.cross(VEC[r"\bar{\delta}^B"], VEC[r"\bar{p}"]) + VEC[r"\bar{d}^B"]
ROOT = sqrt((a - b) ** 2 + (a - c) ** 2 + (b - c) ** 2)
T1, T2, PSI = number(r"\theta_{1,i}"), number(r"\theta_{2,i}"), number(r"\psi_i")
OTHERS = [
    pytest.param(r"\begin{pmatrix} -1/2 & \sqrt{3}/2 & L \\ -1/2 & -\sqrt{3}/2 & L \\ 1 & 0 & L \end{pmatrix} \begin{pmatrix} \dot{X}_m \\ \dot{Y}_m \\ \dot{\phi} \end{pmatrix}",
                 {}, np.array([[-0.5, sqrt(3) / 2, L], [-0.5, -sqrt(3) / 2, L], [1, 0, L]])
                 @ [XM, YM, PHI_DOT], id="trajectory 3"),
    pytest.param(r"\begin{pmatrix} -1/3 & -1/3 & 2/3 \\ 1/\sqrt{3} & -1/\sqrt{3} & 0 \\ 1/3L & 1/3L & 1/3L \end{pmatrix}",
                 {"slash": "all"}, [[-1 / 3, -1 / 3, 2 / 3], [1 / sqrt(3), -1 / sqrt(3), 0],
                                    [1 / (3 * L)] * 3], id="trajectory 4"),
    pytest.param(r"\dot{\phi} = \frac{\nu_1 + \nu_2 + \nu_3}{3L} \tag{5}",
                 {}, (PHI_DOT, (NU1 + NU2 + NU3) / (3 * L)), id="trajectory 5"),
    pytest.param(r"= \frac{1}{3}\sqrt{(-a-b+2c)^2 + \left(\sqrt{3}a - \sqrt{3}b\right)^2}",
                 {}, (sqrt((2 * c - a - b) ** 2 + 3 * (a - b) ** 2) / 3,), id="trajectory 11"),
    pytest.param(r"= \frac{\sqrt{2}}{|a+b+c|} \sqrt{(a-b)^2 + (a-c)^2 + (b-c)^2}",
                 {}, (sqrt(2) * ROOT / abs(a + b + c),), id="trajectory 13"),
    pytest.param(r"\psi = \tan^{-1} \frac{\dot{X}_{W}}{\dot{Y}_{W}} = \frac{\sqrt{3}a - \sqrt{3}b}{-a - b + 2c}",
                 {}, (5 / 7, np.arctan(number(r"\dot{X}_W") / number(r"\dot{Y}_W")),
                      sqrt(3) * (a - b) / (2 * c - a - b)), id="trajectory 14"),
    pytest.param(r"=\frac{\sqrt{2}*3L\sqrt{(a-b)^2+(a-c)^2+(b-c)^2}}{3(a+b+c)}\binom{\cos{(90+\psi)}}{\sin{(90+\psi)}}",
                 {}, (sqrt(2) * 3 * L * ROOT / (3 * (a + b + c))
                      * np.array([cos(90 + 5 / 7), sin(90 + 5 / 7)]),), id="trajectory 16"),
    pytest.param(r"\begin{bmatrix} 0 & -\delta_z & \delta_y & d_x \\ \delta_z & 0 & -\delta_x & d_y \\ -\delta_y & \delta_x & 0 & d_z \\ 0 & 0 & 0 & 0 \end{bmatrix}, \tag{2}",
                 {}, [[0, 5 / 8, 3 / 8, 1 / 7], [-5 / 8, 0, -1 / 8, -2 / 7],
                      [-3 / 8, 1 / 8, 0, 3 / 7], [0] * 4], id="ballbot 2"),
    pytest.param(r"[\bar{\mathbf{n}} \ \bar{\mathbf{o}} \ \bar{\mathbf{a}} \ \bar{\mathbf{p}}]. \tag{3}",
                 {}, np.array([VEC[rf"\bar{{{n}}}"] for n in "noap"]).T, id="ballbot 3"),
    pytest.param(r"\begin{bmatrix} \bar{\mathbf{n}} \cdot (\bar{\delta}^B \times \bar{\mathbf{p}} + \bar{\mathbf{d}}^B) & \bar{\mathbf{o}} \cdot (\bar{\delta}^B \times \bar{\mathbf{p}} + \bar{\mathbf{d}}^B) & \bar{\mathbf{a}} \cdot (\bar{\delta}^B \times \bar{\mathbf{p}} + \bar{\mathbf{d}}^B) \end{bmatrix}^t. \end{aligned} \tag{4-2}",
                 {}, [VEC[rf"\bar{{{n}}}"] @ CROSS for n in "noa"], id="ballbot 4-2"),
    pytest.param(r"\begin{bmatrix} -\frac{1}{2}c\phi & \frac{\sqrt{3}}{2} & -\frac{1}{2}s\phi & \frac{1}{2}Ls\phi \\ s\phi & 0 & c\phi & -Lc\phi \end{bmatrix}, \tag{5-2}",
                 {"functions": {"c": "cos", "s": "sin"}},
                 [[-cos(PHI) / 2, sqrt(3) / 2, -sin(PHI) / 2, L * sin(PHI) / 2],
                  [sin(PHI), 0, cos(PHI), -L * cos(PHI)]], id="ballbot 5-2, two rows"),
    pytest.param(r"\begin{bmatrix} -c\phi d_x^B & Ls\phi \delta_z^B - d_y^B & -s\phi d_x^B \end{bmatrix}^t. \tag{6-2}",
                 {"functions": {"c": "cos", "s": "sin"}},
                 [-cos(PHI) / 4, L * sin(PHI) * DZ + 6 / 5, -sin(PHI) / 4], id="ballbot 6-2"),
    pytest.param(r"v_y^{C_2} = Ls\phi \omega_z^B + \frac{\sqrt{3}}{2} v_x^B + \frac{1}{2} v_y^B, \tag{8}",
                 {"functions": {"c": "cos", "s": "sin"}},
                 (2, L * sin(PHI) * 1.5 + sqrt(3) / 2 * 1.75 - 0.125), id="ballbot 8"),
    pytest.param(r"\langle \eta_i, \omega \rangle = -\frac{v_i}{r} \quad (1)",
                 {}, (VEC[r"\eta_i"] @ VEC[r"\omega"], -9 / 8 / 0.4), id="sphere 1"),
    pytest.param(r"\eta_i = [X_i \cos \psi_i + Y_i \sin \psi_i] \quad (3)",
                 {}, (VEC[r"\eta_i"], VEC["X_i"] * cos(PSI) + VEC["Y_i"] * sin(PSI)),
                 id="sphere 3"),
    pytest.param(r"X_i = \begin{bmatrix} -\sin \theta_{1,i} \\ \cos \theta_{1,i} \\ 0 \end{bmatrix}, Y_i = \begin{bmatrix} -\sin \theta_{2,i} \cos \theta_{1,i} \\ -\sin \theta_{2,i} \sin \theta_{1,i} \\ \cos \theta_{2,i} \end{bmatrix} \quad (4)",
                 {}, ((VEC["X_i"], [-sin(T1), cos(T1), 0]),
                      (VEC["Y_i"], [-sin(T2) * cos(T1), -sin(T2) * sin(T1), cos(T2)])),
                 id="sphere 4"),
    pytest.param(r"\left\| \left( -\frac{v_i}{r} \right) \boldsymbol{\eta}_i + \frac{\langle \mathbf{P}_i, \mathbf{Q} \rangle}{r^2} \mathbf{P}_i - \mathbf{Q} \right\| \quad (6)",
                 {}, NORM(-9 / 8 / 0.4 * VEC[r"\eta_i"]
                          + VEC["P_i"] @ VEC["Q"] / 0.16 * VEC["P_i"] - VEC["Q"]), id="sphere 6"),
    pytest.param(r"\begin{aligned} z_0 &= -\frac{E_9}{2E_3}, y_0 = \frac{D_5 E_9 - 2D_8 E_3}{4D_2 E_3} \\ x_0 &= \frac{1}{8C_1 D_2 E_3} (-C_4 D_5 E_9 + 2C_4 D_8 E_3 \\ &\quad + 2C_6 D_2 E_9 - 4D_2 E_3 C_7) \end{aligned} \quad (7)",
                 {}, ((7, -(2 / 9) / (2 / 3)), (0.25, (10 / 9 - 16 / 3) / (8 / 3)),
                      (3.5, (-(5 / 18) + 4 / 3 + 2 * 1.2 * 4 / 9 - 4 * 2 / 3 * 3.5)
                       / (8 * 7 * 2 / 3))), id="sphere 7"),
    pytest.param(r"\sin(\phi + 240^\circ)", {}, sin(PHI + radians(240)), id="sphere, input"),
]  # fmt: skip

DECLARED = [name for name in (*POINT, *VECTORS) if "^" in name]


def flat(value: Any) -> list[float]:
    """All numbers of a nested value, in order; true counts 1."""
    if isinstance(value, list | tuple | np.ndarray | MatrixBase):
        return [entry for part in value for entry in flat(part)]
    return [float(bool(value)) if value in (True, False) else float(value)]


def shape(value: Any) -> Any:
    """Nesting of tuples, down to what is a number, a vector or a matrix."""
    return tuple(shape(part) for part in value) if isinstance(value, tuple) else ()


@pytest.mark.parametrize(("text", "expected"), ARRANGEMENT)
def test_omni_arrangement(text: str, expected: Any) -> None:
    tree = read(text, Notation(), DECLARED, ["D_V"])
    functions = {
        node.name: Function(MEANINGS[node.name], ("",) * len(node.arguments))
        for node in walk(tree)
        if isinstance(node, Applied)
    }
    value = evaluate(tree, MEANINGS | functions, text)
    assert shape(value) == shape(expected)
    assert flat(value) == pytest.approx(flat(expected), rel=1e-12, abs=1e-12)


@pytest.mark.parametrize(("text", "notation", "expected"), OTHERS)
def test_other_papers(text: str, notation: dict[str, Any], expected: Any) -> None:
    tree = read(text, Notation(**notation), DECLARED)
    value = evaluate(tree, MEANINGS, text)
    assert shape(value) == shape(expected)
    assert flat(value) == pytest.approx(flat(expected), rel=1e-12, abs=1e-12)


PATH = r"""X_{W} = \int_{0}^{t} \left\{ (-\nu_{1} - \nu_{2} + 2\nu_{3}) \cos\left(\frac{1}{3L}
\int_{0}^{t} (\nu_{1} + \nu_{2} + \nu_{3}) dt \right) - (\sqrt{3}\nu_{1} - \sqrt{3}\nu_{2})
\sin\left(\frac{1}{3L} \int_{0}^{t} (\nu_{1} + \nu_{2} + \nu_{3}) dt \right) \right\} dt"""


def test_an_integral_within_an_integral() -> None:
    """Trajectory 8 for constant speeds, by its elementary antiderivative."""
    time = Symbol("t", real=True)
    _, printed = evaluate(read(PATH), {**MEANINGS, "t": time, "X_W": time}, PATH)
    ahead, across = -NU1 - NU2 + 2 * NU3, sqrt(3) * (NU1 - NU2)
    rate = (NU1 + NU2 + NU3) / (3 * L)
    expected = (ahead * sin(2 * rate) - across * (1 - cos(2 * rate))) / rate
    assert float(printed.doit().subs(time, 2)) == pytest.approx(expected, rel=1e-12)


def test_a_function_that_the_paper_prints() -> None:
    text = r"\frac{1}{4} (L(1,1,0) - L(-1,1,0) - L(1,-1,0) \\ &\quad + L(-1,-1,0))"
    x, y, z = symbols("x y z")
    quadratic = Function(1 + 2 * x + 3 * y + 5 * z + 7 * x * y + 13 * x * x, ("x", "y", "z"))
    assert evaluate(read(text, None, [], ["L"]), {"L": quadratic}, text) == 7


def test_rows_are_told_from_columns() -> None:
    column = r"\begin{bmatrix} a & b & c \end{bmatrix}^t"
    assert evaluate(read(column), MEANINGS).shape == (3, 1)
    assert evaluate(read(column[:-2]), MEANINGS).shape == (1, 3)


@pytest.mark.parametrize(
    ("paper", "count", "quantities"),
    [
        pytest.param("omni-arrangement", 31, ["D_V", "D_A", "f_A", "f_{A^{-1}}"], id="arrangement"),
        pytest.param("omni-trajectory", 20, ["r_t", "r_e", "e"], id="trajectory"),
    ],
)
def test_every_display_of_the_source_is_read(paper: str, count: int, quantities: list[str]) -> None:
    source = sources_folder() / f"{paper}.txt"
    if not source.is_file():
        pytest.skip(f"no source text at {source}")
    displays = source.read_text(encoding="utf-8").split("$$")[1::2]
    assert len(displays) == count
    for display in displays:
        read(display, Notation(slash="all"), ["v_k^T", "v_k^R"], quantities)


def test_canonical_names_in_this_file() -> None:
    assert all(symbol_name(name) == name for name in (*POINT, *VECTORS))
