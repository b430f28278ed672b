"""Set-ups solved from printed cells: by hand, from tables of a paper, and at random."""

from fractions import Fraction

import pytest
import sympy as sp
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from omniproof.audit.decimals import Rounding, format_fraction
from omniproof.audit.ranges import POSITIVE, Reading, contains
from omniproof.audit.setups import (
    Cell,
    check_setup,
    contradicting,
    read_as,
    readings_left,
    solve,
)
from omniproof.decide.answer import Undecided
from omniproof.decide.order.intervals import Piece

V, r, w, x, y = sp.symbols("V r w x y", real=True)
pi, sqrt, Q = sp.pi, sp.sqrt, sp.Rational
ROUNDED, TRUNCATED, EITHER = Reading.ROUNDED, Reading.TRUNCATED, Reading.EITHER

MORRIE = 8 * sp.cos(pi / 9) * sp.cos(2 * pi / 9) * sp.cos(4 * pi / 9) - 1  # zero

# Wheel speeds in rpm of a platform with wheels of radius 0.023 m at 30, 150 and 270 degrees.
# N = V * FULL is the speed of a wheel that is driven along the motion.
RADIUS = Q(23, 1000)
FULL = 30 / (pi * RADIUS)
STRAIGHT = {
    0: ("-10.3", "-10.4", "20.8"),
    30: ("0", "-17.9", "17.9"),
    60: ("10.3", "-20.8", "10.4"),
    90: ("17.9", "-17.9", "0"),
}
TURNING = {"left": ("32.9", "1.84", "32.9"), "clockwise": ("-12.2", "-43.3", "-12.2")}


def wheel_speeds(direction: int, turn: sp.Expr, radius: sp.Expr = RADIUS) -> list[sp.Expr]:
    along, across = V * sp.cos(sp.rad(direction)), V * sp.sin(sp.rad(direction))
    half = sqrt(3) / 2 * across
    rolling = (-along / 2 + half, -along / 2 - half, along)
    return [(speed + turn) / radius * 30 / pi for speed in rolling]


def straight(radius: sp.Expr = RADIUS) -> tuple[Cell, ...]:
    """Return the cells of motion without rotation, named `60,N_2`."""
    return tuple(
        Cell(f"{angle},N_{wheel}", printed, speed)
        for angle, row in STRAIGHT.items()
        for wheel, (printed, speed) in enumerate(
            zip(row, wheel_speeds(angle, sp.S.Zero, radius), strict=True), 1
        )
    )


def turning(row: str, turn: sp.Expr) -> tuple[Cell, ...]:
    """Return the cells of motion towards 60 degrees while the rims move at `turn` m/s."""
    speeds = zip(TURNING[row], wheel_speeds(60, turn), strict=True)
    return tuple(Cell(f"{row},N_{k}", text, value) for k, (text, value) in enumerate(speeds, 1))


def in_full_speed(lower: Fraction | str, upper: Fraction | str, closed: tuple[bool, bool]) -> Piece:
    """Return an interval of V, given as one of N = V * FULL."""
    return Piece(Q(str(lower)) / FULL, Q(str(upper)) / FULL, *closed)


# One unknown, by hand --------------------------------------------------------------------------


@pytest.mark.parametrize(
    ("value", "printed", "within", "pieces"),
    [
        pytest.param(2 * x, "3.0", {}, [(Q("1.475"), Q("1.55"), 1, 0)], id="linear"),
        pytest.param(1 - 2 * x, "3.0", {}, [(Q("-1.05"), Q("-0.975"), 0, 1)], id="falling"),
        pytest.param(pi * x, "3", {}, [(Q("2.5") / pi, 4 / pi, 1, 0)], id="irrational factor"),
        pytest.param(6 / x, "3", {x: POSITIVE}, [(Q("1.5"), Q("2.4"), 0, 1)], id="inverse"),
        pytest.param(x**2, "4", {x: POSITIVE}, [(sqrt(Q("3.5")), sqrt(5), 1, 0)], id="square"),
        pytest.param(x**2, "4", {x: Piece(Q(2), Q(9))}, [(Q(2), sqrt(5), 0, 0)], id="cut by range"),
        pytest.param(x**2, "-4", {x: POSITIVE}, [], id="no square"),
        pytest.param(x**2 + 1, "5", {x: POSITIVE}, [(sqrt(Q("3.5")), sqrt(5), 1, 0)], id="shifted"),
        pytest.param(sp.S.Zero, "0.0", {}, [(-sp.oo, sp.oo, 0, 0)], id="constant that fits"),
        pytest.param(sp.S.One, "0.0", {}, [], id="constant that does not"),
        pytest.param(MORRIE * x, "1", {}, [], id="hidden zero"),
        pytest.param(
            MORRIE * x**2 + 2 * x, "3.0", {}, [(Q("1.475"), Q("1.55"), 1, 0)], id="hidden line"
        ),
    ],
)
def test_one_cell(value, printed, within, pieces):
    solution = solve([Cell("a", printed, value)], x, within)
    assert solution.pieces == tuple(Piece(a, b, bool(c), bool(d)) for a, b, c, d in pieces)
    assert solution.is_exact
    assert solution.contradiction == (() if pieces else ("a",))


def test_a_contradiction_names_what_demands_most_and_least():
    """2x in [2.95, 3.1), x in [1.45, 1.6), 3x in [5.95, 6.1): x >= 5.95/3 against x < 1.55."""
    cells = [Cell("a", "3.0", 2 * x), Cell("b", "1.5", x), Cell("c", "6.0", 3 * x)]
    solution = solve(cells, x)
    assert solution.contradiction == ("c", "a")
    assert str(solution.record()) == "none: c, a contradict each other"
    assert str(solve(cells[:2], x).record(4)) == "1.475 ≤ x < 1.550"


def test_cells_that_only_touch():
    """x in [1.5, 2.5] and [2.5, 3.5] when rounded; [2, 3) and [3, 4) when cut off."""
    cells = (Cell("a", "2", x), Cell("b", "3", x))
    assert solve(read_as(cells, ROUNDED), x).pieces == (Piece(Q("2.5"), Q("2.5"), True, True),)
    assert set(solve(read_as(cells, TRUNCATED), x).contradiction) == {"a", "b"}


def test_a_function_of_another_kind_is_enclosed():
    """cos x in [0.45, 0.55] for x in [acos 0.55, acos 0.45] and its mirror image."""
    cell = Cell("a", "0.5", sp.cos(x), ROUNDED)
    solution = solve([cell], x, {x: Piece(Q(-3), Q(3))})
    assert not solution.is_exact
    assert str(solution.record(5)) == "-1.1040 ≤ x ≤ -0.98843 or 0.98843 ≤ x ≤ 1.1040"
    for left, right in ((p.lower, p.upper) for p in solution.pieces[1:]):
        assert left < sp.acos(Q("0.55")) < left + Q("1e-6")
        assert right - Q("1e-6") < sp.acos(Q("0.45")) < right


def test_both_roots_are_found_where_the_unknown_may_be_negative():
    """x^2 in [3.5, 4.5]."""
    solution = solve([Cell("a", "4", x**2, ROUNDED)], x, {x: Piece(Q(-3), Q(3))})
    assert str(solution.record(4)) == "-2.121 ≤ x ≤ -1.871 or 1.871 ≤ x ≤ 2.121"


def test_enclosures_are_widened_beyond_the_digits_that_are_found():
    """z^2 + z in [0.5, 2) for z = 10^6 (x - 1000) in (0, 1): z > (sqrt(3) - 1)/2 = 0.366."""
    z = 10**6 * (x - 1000)
    solution = solve([Cell("a", "1", z**2 + z)], x, {x: Piece(Q(1000), 1000 + Q("1e-6"))})
    ((lower, excess),) = (
        (p.lower, (sqrt(3) - 1) / 2 - z.subs(x, p.lower)) for p in solution.pieces
    )
    assert lower >= 1000
    assert 0 < excess < 0.1


def test_a_contradiction_of_three_cells_with_several_solutions_each():
    """About 1.05 or -1.05; 1.05 or 2.09; -1.05 or 2.09: each two have one in common."""
    quadratic = (x + Q("1.05")) * (x - Q("2.09"))
    cells = [
        Cell("a", "0.50", sp.cos(x)),
        Cell("b", "0.87", sp.sin(x)),
        Cell("c", "0.00", quadratic),
    ]
    within = {x: Piece(Q(-3), Q(3))}
    assert set(solve([*cells, Cell("d", "0", x / 9)], x, within).contradiction) == {"a", "b", "c"}
    for spared in range(3):
        assert len(solve(cells[:spared] + cells[spared + 1 :], x, within).pieces) == 1


@pytest.mark.parametrize(
    ("value", "reason"),
    [
        pytest.param(sp.cos(x), "a: the range of x is not bounded", id="no range given"),
        pytest.param(x * y, "a is not linear in x, y", id="product of unknowns"),
        pytest.param(sp.Float(0.5) * x, "0.500000000000000 is a floating-point", id="float"),
    ],
)
def test_what_is_not_solved(value, reason):
    answer = solve([Cell("a", "1", value)], x)
    assert isinstance(answer, Undecided)
    assert answer.reason.startswith(reason)


# Several unknowns, by hand ---------------------------------------------------------------------


def test_elimination():
    """x + y in [3, 4), x - y in [1, 2): 2x in [4, 6); y in (1/2, 3/2)."""
    cells = read_as([Cell("a", "3", x + y), Cell("b", "1", x - y)], TRUNCATED)
    assert solve(cells, x).pieces == (Piece(Q(2), Q(3), True, False),)
    assert solve(cells, y).pieces == (Piece(Q(1, 2), Q(3, 2)),)


def test_a_contradiction_of_three_cells_with_two_unknowns():
    """x + y < 4 and x - y < 2 allow x < 3 only; b and c alone, or a and c, allow x = 5."""
    cells = read_as(
        [Cell("a", "3", x + y), Cell("b", "1", x - y), Cell("c", "5", x), Cell("d", "0", 0 * x)],
        TRUNCATED,
    )
    assert set(solve(cells, x).contradiction) == {"a", "b", "c"}
    assert set(solve(cells, y).contradiction) == {"a", "b", "c"}


def test_the_range_of_an_eliminated_unknown_counts():
    cells = [Cell("a", "3", x + y, TRUNCATED)]
    assert solve(cells, x, {y: POSITIVE}).pieces == (Piece(-sp.oo, Q(4)),)


# Tables of a paper -----------------------------------------------------------------------------


def test_a_table_of_straight_motion():
    """In N = V * FULL, the 20.8 cells demand N >= 20.75, those of 17.9 = sqrt(3)/2 N demand
    N < 18 * 2/sqrt(3) = 20.785 (cut off). Rounded 17.95 * 2/sqrt(3) = 20.727, and rounded 10.35 * 2
    = 20.7, miss 20.75. Cut off, 10.4 demands N >= 20.8, which misses 20.785.
    """
    cells = straight()
    either = solve(cells, V)
    lower, upper = in_full_speed("20.75", "18", (True, False)).lower, 18 * 2 / sqrt(3) / FULL
    assert either.pieces == (Piece(lower, upper, True, False),)
    assert str(either.record()) == "0.0499775 ≤ V < 0.0500609"
    assert set(solve(read_as(cells, ROUNDED), V).contradiction) == {"0,N_1", "0,N_3"}
    assert set(solve(read_as(cells, TRUNCATED), V).contradiction) == {"0,N_2", "30,N_2"}


def test_one_cell_of_the_table():
    """20.8 is [20.75, 20.9) in N: V from 0.0499775 to 0.0503388; 0.022 is not in it."""
    cell = straight()[2]
    assert solve([cell], V).pieces == (in_full_speed("20.75", "20.9", (True, False)),)
    assert not contains(solve([cell], V).pieces[0], Q("0.022"))


def test_which_cells_of_the_table_are_cut_off():
    """With N in [20.75, 20.785): N/2 in [10.375, 10.392) is 10.4 only when rounded, 10.3 only when
    cut off; sqrt(3)/2 N in [17.970, 18) is 17.9 only when cut off; N is 20.8 only when rounded.
    """
    left = readings_left(straight(), V)
    wanted = {"10.3": (TRUNCATED,), "10.4": (ROUNDED,), "20.8": (ROUNDED,), "17.9": (TRUNCATED,)}
    for cell in straight():
        assert left[cell.name] == wanted.get(cell.printed.strip("-"), (ROUNDED, TRUNCATED))


def test_the_stated_speed_contradicts_every_cell_but_the_zeros():
    """V = 0.022: N = 9.134 against 20.8, an error of 20.8/9.134 - 1 = 1.28."""
    checked = check_setup(straight(), {V: Q("0.022")})
    wrong = [cell.name for cell in straight() if cell.printed != "0"]
    for reading in Reading:
        assert list(contradicting(checked, reading)) == wrong
    assert checked[2].finding.rounding is Rounding.WRONG
    assert (checked[2].finding.digits, checked[2].finding.relative_error) == ("9.13411", "1.3")


def test_another_speed_explains_all_cells():
    """V = 0.05: N = 20.759, N/2 = 10.380, sqrt(3)/2 N = 17.978."""
    checked = check_setup(straight(), {V: Q("0.05")})
    assert contradicting(checked, EITHER) == ()
    rounded, cut = contradicting(checked, ROUNDED), contradicting(checked, TRUNCATED)
    assert rounded == ("0,N_1", "30,N_2", "30,N_3", "60,N_1", "90,N_1", "90,N_2")
    assert cut == ("0,N_2", "0,N_3", "60,N_2", "60,N_3")


@pytest.mark.parametrize(
    ("row", "reading", "lower", "upper", "closed"),
    [
        # N_1 - N_2 = 3/2 N: [32.85, 32.95] - [1.835, 1.845] = [31.005, 31.115]
        pytest.param("left", ROUNDED, "31.005", "31.115", True, id="left, rounded"),
        # [32.9, 33) - [1.84, 1.85) = (31.05, 31.16)
        pytest.param("left", TRUNCATED, "31.05", "31.16", False, id="left, cut off"),
        # [32.85, 33) - [1.835, 1.85) = (31, 31.165)
        pytest.param("left", EITHER, "31", "31.165", False, id="left"),
        # [-12.25, -12.15] - [-43.35, -43.25] = [31, 31.2]
        pytest.param("clockwise", ROUNDED, "31", "31.2", True, id="clockwise, rounded"),
        # (-12.3, -12.2] - (-43.4, -43.3] = (31, 31.2)
        pytest.param("clockwise", TRUNCATED, "31", "31.2", False, id="clockwise, cut off"),
        # (-12.3, -12.15] - (-43.4, -43.25] = (30.95, 31.25)
        pytest.param("clockwise", EITHER, "30.95", "31.25", False, id="clockwise"),
    ],
)
def test_a_table_of_turning_motion(row, reading, lower, upper, closed):
    """Whatever the rate, the difference of two wheels tells the speed."""
    pieces = solve(read_as(turning(row, w), reading), V).pieces
    two_thirds = [Q(end) * Q(2, 3) / FULL for end in (lower, upper)]
    assert pieces == (Piece(*two_thirds, closed, closed),)


def test_the_rate_of_turning():
    """N_1 + N_1 + N_2 = 3 turn: 2 [32.85, 33) + [1.835, 1.85) = [67.535, 67.85)."""
    pieces = solve(turning("left", w), w).pieces
    assert pieces == (Piece(Q("67.535") / 3 / FULL, Q("67.85") / 3 / FULL, True, False),)


def test_both_tables_together():
    """N in [20.75, 20.785) meets (31, 31.165) * 2/3, which ends at 20.7767."""
    cells = (*straight(), *turning("left", w), *turning("clockwise", -w))
    pieces = solve(cells, V).pieces
    assert pieces == (Piece(Q("20.75") / FULL, Q("31.165") * Q(2, 3) / FULL, True, False),)


def test_the_turning_cells_contradict_the_stated_speed():
    """3/2 * 9.134 = 13.70 against 31: two cells of one row suffice, whatever the rate."""
    stated = {V: Piece(Q("0.022"), Q("0.022"), True, True)}
    assert set(solve(turning("left", w), V, stated).contradiction) == {"left,N_1", "left,N_2"}


# At random -------------------------------------------------------------------------------------

factors = st.fractions(-5, 5, max_denominator=12).filter(bool)
rows = st.lists(st.tuples(factors, st.integers(0, 3), st.booleans()), min_size=2, max_size=6)
speeds = st.fractions(Fraction(1, 100), 20, max_denominator=1000)


def written(value: Fraction, places: int, cut: bool) -> str:
    """Print a number, cut off or rounded half away from zero, by integers only."""
    steps = abs(value) * 10**places
    whole = int(steps) if cut else int(steps + Fraction(1, 2))
    shown = Fraction(whole, 10**places)
    return format_fraction(-shown if value < 0 else shown, Fraction(1, 10**places))


def rational(value: Fraction) -> sp.Rational:
    return Q(value.numerator, value.denominator)


def printed_cells(truth: Fraction, rows: list, given: bool) -> list[Cell]:
    """Print rows of (factor, places, cut off); tell how each was printed, or leave it open."""
    return [
        Cell(
            f"c{k}",
            written(factor * truth, places, cut),
            rational(factor) * x,
            (TRUNCATED if cut else ROUNDED) if given else EITHER,
        )
        for k, (factor, places, cut) in enumerate(rows)
    ]


@settings(max_examples=80, deadline=None)
@given(speeds, rows, st.booleans())
def test_printed_cells_allow_their_set_up(truth, rows, given):
    solution = solve(printed_cells(truth, rows, given), x)
    assert any(contains(piece, rational(truth)) for piece in solution.pieces)
    assert solution.contradiction == ()


@settings(max_examples=40, deadline=None)
@given(speeds, speeds, st.lists(st.tuples(factors, factors, st.booleans()), min_size=2, max_size=5))
def test_printed_cells_of_two_unknowns_allow_their_set_up(first, second, rows):
    cells = [
        Cell(f"c{k}", written(a * first + b * second, 2, cut), rational(a) * x + rational(b) * y)
        for k, (a, b, cut) in enumerate(rows)
    ]
    for unknown, truth in ((x, first), (y, second)):
        pieces = solve(cells, unknown).pieces
        assert any(contains(piece, rational(truth)) for piece in pieces)


@settings(max_examples=60, deadline=None)
@given(speeds, rows, st.booleans(), st.sampled_from([-1, 1]))
def test_a_shifted_cell_is_proved_to_contradict(truth, rows, given, side):
    """Another cell fixes x to less than two of its units; a shift by more than that is refuted."""
    cells = printed_cells(truth, rows, given)
    (f0, places0, _), (f1, places1, cut1) = rows[:2]
    unit0, unit1 = Fraction(1, 10**places0), Fraction(1, 10**places1)
    shift = side * (2 * unit0 * abs(f1 / f0) + 3 * unit1)
    assume((f1 * truth + shift) * f1 * truth > 0)
    moved = written(f1 * truth + shift, places1, cut1)
    cells[1] = Cell("moved", moved, cells[1].value, cells[1].reading)
    contradiction = solve(cells, x).contradiction
    assert "moved" in contradiction
    assert len(contradiction) == 2
    for spared in contradiction:
        assert solve([c for c in cells if c.name in contradiction and c.name != spared], x).pieces


@settings(max_examples=60, deadline=None)
@given(speeds, rows)
def test_the_true_set_up_is_confirmed_as_printed(truth, rows):
    checked = check_setup(printed_cells(truth, rows, given=True), {x: rational(truth)})
    for line, (_, _, cut) in zip(checked, rows, strict=True):
        assert (TRUNCATED if cut else ROUNDED) in line.readings
    assert contradicting(checked, EITHER) == ()


@settings(max_examples=25, deadline=None)
@given(st.fractions(Fraction(1, 10), 9, max_denominator=100), st.integers(0, 3), st.booleans())
def test_enclosed_solutions_keep_the_set_up(truth, places, cut):
    cell = Cell("a", written(truth**2 + truth, places, cut), x**2 + x)
    solution = solve([cell], x, {x: Piece(Q(0), Q(10))})
    assert any(contains(piece, rational(truth)) for piece in solution.pieces)
    assert not solution.is_exact
