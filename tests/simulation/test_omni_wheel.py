"""The wheel of the models: where its rollers are, which way it drives, what it refuses."""

import mujoco
import numpy as np
import pytest

from omniproof.simulation import omni_wheel
from omniproof.simulation.omni_wheel import Wheel


def compiled(wheel, running=(1, 0, 0), up=(0, 0, 1)):
    """A wheel that touches the origin from above its surface."""
    hub = wheel.radius * np.array(up, dtype=float)
    model = mujoco.MjModel.from_xml_string(
        f"""<mujoco><default>{omni_wheel.roller_class(wheel)}</default><worldbody>
        {omni_wheel.body(wheel, "wheel", hub, running, up)}</worldbody>
        <actuator>{omni_wheel.motor(wheel, "wheel")}</actuator></mujoco>"""
    )
    data = mujoco.MjData(model)
    mujoco.mj_forward(model, data)
    return model, data


@pytest.mark.parametrize(
    ("running", "up"),
    [
        pytest.param((1, 0, 0), (0, 0, 1), id="on a floor"),
        pytest.param((0, 1, 0), (0, 0, 1), id="on a floor, sideways"),
        pytest.param((0, 1, 0), (0.6, 0, -0.8), id="under a slope"),
    ],
)
def test_a_positive_rate_carries_the_hub_along_the_running_direction(running, up):
    """The rim at the contact goes backwards, by the radius times the rate."""
    model, data = compiled(Wheel(0.05), running, up)
    jacobian = np.zeros((3, model.nv))
    mujoco.mj_jac(model, data, jacobian, None, np.zeros(3), model.body("wheel").id)
    rim = jacobian[:, model.joint("wheel").dofadr[0]]
    assert rim == pytest.approx(-0.05 * np.array(running), abs=1e-9)


@pytest.mark.parametrize("rows", [1, 2, 3])
def test_rollers_stand_on_the_rim(rows):
    """Outermost points on the radius, axes along the rim, rows side by side about the middle."""
    wheel = Wheel(0.05, rollers=12, rows=rows, row_distance=0.02, roller_radius=0.01)
    _, data = compiled(wheel)
    places = data.geom_xpos - data.body("wheel").xpos
    radial = np.hypot(places[:, 0], places[:, 2])
    axes = data.geom_xmat.reshape(-1, 3, 3)[:, :, 2]
    assert radial == pytest.approx(np.full(12, 0.04), abs=1e-7)
    assert np.einsum("ij,ij->i", axes, places * [1, 0, 1]) == pytest.approx(0, abs=1e-9)
    assert axes[:, 1] == pytest.approx(0, abs=1e-9)
    sideways = 0.02 * (np.arange(rows) - (rows - 1) / 2)
    assert np.unique(places[:, 1].round(9)) == pytest.approx(sideways, abs=1e-9)


def test_the_outline_has_the_curvature_of_the_rim():
    """An ellipse with half-axes a along and b across has the radius of curvature a^2 / b there."""
    model, _ = compiled(Wheel(0.05, roller_radius=0.01))
    across, _, along = model.geom_size[0]
    assert along**2 / across == pytest.approx(0.05)


def test_rollers_that_cannot_be_shared_out_are_refused():
    with pytest.raises(ValueError, match="expected rollers in 4 equal rows, got 18"):
        omni_wheel.body(Wheel(0.05, rows=4), "wheel", (0, 0, 0), (1, 0, 0), (0, 0, 1))
