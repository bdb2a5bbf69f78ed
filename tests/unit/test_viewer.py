"""The viewer in a real browser: what it shows is where Pinocchio says it is, and everything on it can be used."""

import io
import logging
import os
import re
import signal
import socket
import subprocess
import sys
import threading
import time
import urllib.request
from contextlib import contextmanager
from dataclasses import replace
from itertools import groupby

import coal
import numpy as np
import pinocchio as pin
import pytest
import trimesh
import viser
from axe_playwright_python.sync_playwright import Axe
from PIL import Image

import manipplan as mp
from manipplan.cli import main
from manipplan.support.status import Status
from manipplan.viz import viewer
from manipplan.viz.motions import ShownMotion, nearest_now
from manipplan.viz.shapes import MOST, triangles_of
from manipplan.viz.viewer import plan_viewer, replanner
from manipplan.viz.viewer import server as pages
from manipplan.viz.viewer.bodies import appearance_of, capsules, convex_bodies
from manipplan.viz.viewer.plan_viewer import LEFT, RIGHT, WIDTH, Chart, ChartLine, chart_of
from manipplan.viz.viewer.stage import GHOST, corners, right_of
from manipplan.viz.viewer.teleoperation import gauge_rows

FLAGS = (
    "--no-sandbox --use-angle=swiftshader --enable-unsafe-swiftshader --ignore-gpu-blocklist --disable-background-networking "
    "--no-first-run --disable-component-update --disable-sync"
)
#: What viser's own page says about the library it uses.
KNOWN = {"THREE.Clock: This module has been deprecated. Please use THREE.Timer instead."}
SIZE = {"width": 640, "height": 320}


@contextmanager
def watched(browser):
    """Opens addresses; whatever the pages complain about, or ask for from elsewhere, is an error at the end.

    They are closed there: each open page takes a share of the processor, as it draws without a graphics card.
    """
    said, asked, opened = [], [], []

    def open_(url):
        page = browser.new_page(viewport=SIZE)
        page.set_default_timeout(120_000)  # [ms]: a page drawn without a graphics card, beside other tests
        page.on("console", lambda message: said.append(message.text) if message.type in ("error", "warning") else None)
        page.on("pageerror", lambda error: said.append(str(error)))
        page.on("request", lambda request: asked.append(request.url))
        opened.append((page, url))
        page.goto(url)
        settled(page)
        return page

    yield open_
    for page, _ in opened:
        page.close()
    assert set(said) <= KNOWN
    allowed = tuple(start for _, url in opened for start in (url, f"blob:{url}", f"ws:{url.partition(':')[2]}"))
    assert [url for url in asked if not url.startswith((*allowed, "data:", "blob:null"))] == []


@pytest.fixture
def open_page(browser):
    with watched(browser) as open_:
        yield open_


@pytest.fixture(scope="module")
def page(shown, browser):
    """The plan's page, which several tests use."""
    with watched(browser) as open_:
        yield open_(shown.url)


@pytest.fixture(scope="module")
def plan():
    arm = mp.planar_arm([1.0, 1.0, 1.0])
    scene = mp.Scene([mp.Box(size=(0.3, 0.3, 0.3), position=(0.0, -2.0, 0.0), name="block")])
    return mp.plan(arm, [0.0, 1.5, -2.0], [np.pi, -2.0, 2.0], scene, objective=mp.PathObjective(power=2.0))


@pytest.fixture(scope="module")
def shown(plan):
    with plan.show(port=0, open_browser=False) as page:
        yield page


def moved(plan, robot, start=None, scene=None):
    """A plan that was not optimised, from one posture to another nearby; its figures are those of the given plan."""
    start = robot.neutral if start is None else np.asarray(start)
    path = mp.JointPath.line(start, robot.random_configuration(np.random.default_rng(1)) * 0.3 + start * 0.7)
    motion, result = mp.retime(path, robot), replace(plan.result, path=path, seed=path, task=robot.default_task)
    report = replace(plan.report, digest=motion.digest)
    return replace(plan, robot=robot, scene=scene or mp.Scene(), path=path, trajectory=motion, result=result, report=report)


def picture(page):
    """The 3D picture as an array (h, w, 3)."""
    canvas = page.locator("canvas").first.bounding_box()
    shot = Image.open(io.BytesIO(page.screenshot())).convert("RGB")
    return np.asarray(shot.crop((0, 0, round(canvas["width"]), round(canvas["height"])))).astype(int)


def settled(page, seconds=1.0):
    """Waits until the panel stands beside the picture, which becomes narrower by it, or there is none."""
    canvas = page.locator("canvas").first
    canvas.wait_for()
    width, since = canvas.bounding_box()["width"], time.monotonic()
    while time.monotonic() < since + seconds:
        page.wait_for_timeout(100)
        now = canvas.bounding_box()["width"]
        if now != width:
            width, since = now, time.monotonic()


def drawn(page, *, differs_from=None, seconds=120.0):
    """The picture once there is something on it, and something else than on `differs_from`."""
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        page.bring_to_front()  # a browser need not draw a page behind another one
        image = picture(page)
        colourful = (np.ptp(image, axis=2) > 60).mean()  # the arm's paths and ellipsoids; the floor is grey
        if colourful > 1e-3 and (differs_from is None or (np.abs(image - differs_from).max(axis=2) > 40).mean() > 1e-3):
            return image
        page.wait_for_timeout(150)
    pytest.fail("the picture stayed empty, or the same")


def click_in_chart(page, share, chosen):
    """Click where a share of the duration is on the axis of time, until `chosen()`.

    The panel is scrolled there. A page that is drawn without a graphics card may move below the pointer between two calls,
    as what was asked of it before arrives late.
    """
    end = time.monotonic() + 120.0
    while not chosen():
        assert time.monotonic() < end, "no click changed the time"
        place = page.evaluate("""() => {
            const chart = document.querySelector('svg[data-time]');
            chart.scrollIntoView({block: 'center', behavior: 'instant'});
            return chart.getBoundingClientRect().toJSON();
        }""")
        scale = place["width"] / WIDTH
        page.mouse.click(place["x"] + scale * (LEFT + share * (WIDTH - LEFT - RIGHT)), place["y"] + place["height"] / 2)
        for _ in range(50):
            if chosen():
                break
            page.wait_for_timeout(100)


def drag(page, places, done):
    """Drag an arrow in the picture until `done()`; `places()` are those of the arrow now and after the drag [px].

    Without a graphics card it may take seconds until the arrow notices the pointer, and it may follow a part of the way only.
    """
    end = time.monotonic() + 180.0
    patience = 500
    while not done():
        assert time.monotonic() < end, "nothing was dragged"
        begin, there = places()
        page.bring_to_front()
        page.mouse.move(begin[0] - 3.0, begin[1])
        page.mouse.move(*begin)
        page.wait_for_timeout(patience)
        page.mouse.down()
        page.wait_for_timeout(patience)
        page.mouse.move(*there, steps=6)
        page.wait_for_timeout(patience)
        page.mouse.up()
        for _ in range(10):
            if done():
                break
            page.wait_for_timeout(patience // 5)
        patience = min(2 * patience, 8000)


def no_serious_fault(page):
    """Nothing that is ours breaks a rule of accessibility."""
    found = Axe().run(page, context=".figures", options={"rules": {"color-contrast": {"enabled": False}}})
    assert [each["id"] for each in found.response["violations"] if each["impact"] in ("serious", "critical")] == []


def wait_until(true, seconds=60.0, every=0.02):
    end = time.monotonic() + seconds
    while not true():
        assert time.monotonic() < end, "nothing happened"
        time.sleep(every)


def rate_of(shown):
    """Seconds of the motion that pass in a second, between two moments at which the time that is shown changes."""

    def change():
        before = shown.time
        wait_until(lambda: shown.time != before, every=0.001)
        return shown.time, time.monotonic()

    start, began = change()
    time.sleep(0.3)
    end, ended = change()
    return (end - start) / (ended - began)


def tool_of(figure):
    """The last joint of a figure as the browser has it, (4, 4)."""
    frame = figure.frames[-1]
    w, x, y, z = frame.wxyz
    return pin.SE3(pin.Quaternion(w, x, y, z).toRotationMatrix(), np.asarray(frame.position)).homogeneous


def last_joint(robot, q):
    data = robot.model.createData()
    pin.forwardKinematics(robot.model, data, np.asarray(q))
    return data.oMi[robot.model.njoints - 1].homogeneous


def test_the_slider_moves_the_robot(shown, page):
    before = drawn(page)
    box = page.get_by_role("textbox").first
    assert box.input_value() == "0"
    for t in (0.6, 1.13):
        box.fill(str(t))
        box.press("Enter")
        wait_until(lambda t=t: abs(shown.time - t) < 1e-9)
        wait_until(
            lambda t=t: (
                abs(tool_of(shown.stage.figures[0].robot) - last_joint(shown.motion.robot, shown.motion.trajectory(t))).max()
                < 1e-9
            )
        )
        before = drawn(page, differs_from=before)
    assert f"{shown.time:.2f} of {shown.motion.trajectory.duration:.2f} s" in page.content()
    value = float(shown.motion.kinematics.manipulability(shown.motion.trajectory(1.13)))
    assert f"{value:.4g} m²" in page.content()
    ellipsoid, jacobian = (
        shown.stage.figures[0].ellipsoids[0].mesh,
        shown.motion.tools[0].jacobian(shown.motion.trajectory(1.13)),
    )
    np.testing.assert_allclose(ellipsoid.scale[:2], shown.motion.scale * np.linalg.svd(jacobian)[1], rtol=1e-9)
    np.testing.assert_allclose(ellipsoid.position, shown.motion.tools[0].pose(shown.motion.trajectory(1.13))[:3, 3], atol=1e-9)


def test_it_plays_at_real_speed_and_stops(shown, page):
    shown.time = 0.1
    page.get_by_role("button", name="Play").click()
    wait_until(lambda: shown.playing)
    rates = []
    for _ in range(3):  # the machine may be busy once
        shown.time = 0.1
        rates.append(rate_of(shown))
    assert min(abs(rate - 1.0) for rate in rates) < 0.1, rates
    shown.speed = 0.05  # so that the end is far away, however late the click comes
    page.get_by_role("button", name="Pause").click()
    wait_until(lambda: not shown.playing)
    still = shown.time
    time.sleep(0.2)
    assert shown.time == still
    shown.time, shown.speed, shown.repeats = shown.motion.trajectory.duration - 0.05, 0.25, False
    began = time.monotonic()
    shown.play()
    wait_until(lambda: not shown.playing)
    assert shown.time == shown.motion.trajectory.duration
    assert 0.15 < time.monotonic() - began < 0.6
    shown.play()  # from the start again
    assert shown.time < 0.1
    shown.repeats, shown.speed, shown.time = True, 1.0, shown.motion.trajectory.duration - 0.1
    shown.play()
    wait_until(lambda: 0.1 < shown.time < 0.5)  # once more, after a pause
    assert shown.playing
    shown.pause()


def test_switches_hide_what_they_name(shown, page):
    before = drawn(page)
    labels = list(shown.stage.layers)
    assert labels[:5] == ["side by side", "optimised", "seed", "path, optimised", "path, seed"]
    boxes = page.get_by_role("checkbox")
    assert boxes.count() == 1 + len(labels)
    for k, name in enumerate(labels[:5], start=1):  # the first one repeats the motion
        boxes.nth(k).click(force=True)
        wait_until(lambda name=name: not shown.stage.layers[name].visible)
    drawn(page, differs_from=before)
    for name in labels[:5]:
        shown.stage.layers[name].visible = True


@pytest.mark.slow
def test_what_is_checked_replaces_the_links(plan):
    """The bodies stand where Pinocchio puts those of the collision model; the links are hidden meanwhile."""
    robot = mp.planar_arm([0.5, 0.4])
    scene = mp.Scene([mp.Box(size=(0.1, 0.1, 0.1), position=(2.0, 0.0, 0.0))])
    plan = moved(plan, robot, scene=scene)
    with plan.show(port=0, open_browser=False) as page:
        checked, around = (page.stage.layers[name] for name in ("what is checked", "controller's capsules"))
        assert not checked.visible and not around.visible
        names = [f"/robot/{body.joint}/checked{k}" for k, body in enumerate(convex_bodies(robot))]
        assert names and not any(page.server.scene.get_handle_by_name(name) for name in names)  # made when first shown
        checked.visible = True
        page.time = 0.6 * plan.trajectory.duration
        model = scene.collision_model(robot)
        data, placed = robot.model.createData(), pin.GeometryData(model.geometry)
        pin.updateGeometryPlacements(robot.model, data, model.geometry, placed, plan.trajectory(page.time))
        for k, name in enumerate(names):
            handle, item = page.server.scene.get_handle_by_name(name), model.geometry.geometryObjects[k]
            frame = page.stage.figures[0].robot.frames[item.parentJoint]
            turn = pin.Quaternion(*(float(c) for c in frame.wxyz)).toRotationMatrix()
            ours = np.asarray(handle.vertices) @ turn.T + frame.position
            theirs = triangles_of(item.geometry)[0] @ placed.oMg[k].rotation.T + placed.oMg[k].translation
            np.testing.assert_allclose(ours, theirs, atol=1e-6)
            assert handle.visible
        assert not any(link.visible for link in page.stage.figures[0].robot.meshes)
        around.visible = True
        checked.visible = False
        assert all(link.visible for link in page.stage.figures[0].robot.meshes)
        assert not any(page.server.scene.get_handle_by_name(name).visible for name in names)
        assert page.server.scene.get_handle_by_name("/robot/1/capsule0").visible


def test_capsules_are_drawn_where_the_controller_has_them():
    robot = mp.planar_arm([0.5, 0.4])
    controller = mp.Controller(robot, mp.formulations.Classical(), dt=0.01, compiled=False)
    for drawn_body, body in zip(capsules(robot), controller.bodies, strict=True):
        axis = body.end - body.start
        share = np.clip((drawn_body.vertices - body.start) @ axis / (axis @ axis), 0.0, 1.0)
        distances = np.linalg.norm(drawn_body.vertices - body.start - share[:, None] * axis, axis=1)
        np.testing.assert_allclose(distances, body.radius, atol=1e-4)
        assert drawn_body.joint == body.joint


@pytest.mark.slow
def test_there_is_nothing_to_check_without_collision_geometry(plan, tmp_path):
    file = tmp_path / "arm.urdf"
    file.write_text(ARM.format(visual="", collision=""))
    plan = moved(plan, mp.Robot.from_urdf(file, tool="tip"), start=[0.1, 0.1, 0.1])
    with plan.show(port=0, open_browser=False) as page:
        assert "what is checked" not in page.stage.layers


def test_the_two_motions_stand_beside_each_other_or_at_one_place(shown):
    """Also at the start, where both arms are the same."""
    shown.time, stage = 0.0, shown.stage
    node = shown.server.scene.get_handle_by_name
    assert stage.apart and node("/beside/apart").visible
    ours, seeds = (
        np.concatenate([corners(stage.motion.robot, q, moving=True) for q in each.q[::20]]) for each in stage.motion.motions
    )
    right = right_of(stage.motion.robot)
    assert (ours @ right).min() > ((seeds + stage.around.aside) @ right).max()
    np.testing.assert_allclose(node("/beside").position, stage.around.aside)
    assert node("/beside/apart/obstacles").visible and all(mesh.visible for mesh in stage.figures[1].robot.meshes)
    stage.layers["side by side"].visible = False
    np.testing.assert_allclose(node("/beside").position, 0.0)
    assert not node("/beside/apart").visible and not stage.figures[0].title.visible
    assert {mesh.opacity for mesh in stage.figures[1].robot.meshes if mesh.visible} == {GHOST}
    stage.layers["side by side"].visible = True


def test_a_click_in_the_chart_and_a_button_choose_the_time(shown, page):
    for share in (0.3, 0.8):
        click_in_chart(page, share, lambda share=share: abs(shown.time - share * shown.motion.trajectory.duration) < 0.02)
    page.get_by_role("button", name="Worst moment").click()
    wait_until(lambda: shown.time == shown.motion.worst)
    t = np.linspace(0.0, shown.motion.trajectory.duration, 2000)
    m = shown.motion.kinematics.manipulability(shown.motion.trajectory(t))
    assert shown.motion.kinematics.manipulability(shown.q) == pytest.approx(m.min(), rel=1e-3)
    no_serious_fault(page)


def test_the_arm_is_moved_by_hand(shown, page):
    shown.time = 0.5
    page.get_by_text("Move by hand").click()
    q = shown.q
    page.get_by_role("slider").nth(1).press("End")  # after the time: the first joint
    wait_until(lambda: shown.q[0] > q[0] + 1.0)
    np.testing.assert_allclose(shown.q[1:], q[1:], atol=1e-3)
    wait_until(lambda: abs(tool_of(shown.stage.figures[0].robot) - last_joint(shown.motion.robot, shown.q)).max() < 1e-9)
    page.get_by_text("moved by hand").wait_for()
    m = float(shown.motion.kinematics.manipulability(shown.q))
    page.get_by_text(f"{m:.4g} m²").first.wait_for()
    shown.play()
    wait_until(lambda: shown.time > 0.6)
    assert abs(shown.q[0] - shown.motion.trajectory(shown.time)[0]) < 0.1
    shown.pause()
    for wrong in ([0.0, 0.0], [0.0, 0.0, np.nan]):
        with pytest.raises(mp.errors.InvalidInputError, match="q"):
            shown.q = wrong


@pytest.mark.slow
def test_the_nearest_obstacle_is_said_in_words():
    """Among boxes, at moments spread over a motion, and with a part in the hand: as the scene measures it."""
    job = mp.demo.panda_among_boxes()
    model = job.scene.collision_model(job.robot)
    for q in (job.start, job.goal):
        [(name, words)] = nearest_now(model, q)
        apart = job.scene.distances(job.robot, q)
        outside = [k for k, (_, second) in enumerate(model.pair_names) if second in job.scene.names]
        nearest = outside[int(apart[outside].argmin())]
        link, obstacle = model.pair_names[nearest]
        assert name == "nearest obstacle"
        assert words == f"{link.rpartition('_')[0]} {1e3 * apart[nearest]:.1f} mm from {obstacle}"
    alone = mp.Scene().collision_model(job.robot)
    [(name, words)] = nearest_now(alone, job.start)
    assert name == "nearest links" and f" {1e3 * mp.Scene().distances(job.robot, job.start).min():.0f} mm from " in words


def test_it_plans_again_among_moved_obstacles(plan, open_page):
    """In the browser: the block is dragged into the way, and the new motion keeps clear of it."""
    with plan.show(port=0, open_browser=False) as live:
        page = open_page(live.url)
        drawn(page)
        page.get_by_text("Plan again").first.click()
        page.get_by_role("combobox", name="drag").click()
        page.get_by_role("option", name="block").click()
        again = live.replanner
        wait_until(lambda: again.arrows.visible)
        np.testing.assert_allclose(again.arrows.position, [0.0, -2.0, 0.0])
        page.evaluate("document.querySelectorAll('.mantine-Notification-closeButton').forEach(each => each.click())")
        [client] = live.server.get_clients().values()

        def places():
            at, size = np.array(again.arrows.position), again.arrows.scale
            return [project(client.camera, page, [0.0, y, 0.0]) for y in (at[1] + 0.6 * size, -1.6 + 0.6 * size)]

        drag(page, places, lambda: again.scene.obstacles[0].position[1] > -1.7)
        moved_to = again.scene.obstacles[0].position
        np.testing.assert_allclose(moved_to[[0, 2]], 0.0, atol=1e-6)
        camera = np.array(client.camera.position)
        page.get_by_role("button", name="Plan again").last.click()
        wait_until(lambda: live.motion.plan is not plan)
        wait_until(lambda: not again.planning)
        np.testing.assert_array_equal(live.motion.plan.scene.obstacles[0].position, moved_to)
        assert live.motion.plan.result.power == plan.result.power == 2.0
        page.get_by_role("status").get_by_text("every check passed").wait_for()
        np.testing.assert_allclose(client.camera.position, camera, atol=1e-6)
        box = page.get_by_role("textbox").first
        box.fill("0.4")
        box.press("Enter")
        wait_until(lambda: abs(live.time - 0.4) < 1e-9)


@pytest.mark.slow
def test_planning_again_fails_in_words_and_can_be_stopped(plan, monkeypatch):
    with plan.show(port=0, open_browser=False) as live:
        again = live.replanner
        again.choose(1)
        far = pin.SE3(np.eye(3), np.array([9.0, 0.0, 0.0]))
        again.move(far)
        again.plan()
        wait_until(lambda: not again.planning)
        assert "out of reach" in again.text and live.motion.plan is plan
        again.move(pin.SE3(np.eye(3), np.array([1.5, 1.0, 0.0])))
        again.plan()
        wait_until(lambda: live.motion.plan is not plan)
        wait_until(lambda: not again.planning)
        np.testing.assert_allclose(plan.robot.kinematics().pose(live.motion.plan.path.goal)[:2, 3], [1.5, 1.0], atol=1e-6)
        made = live.motion.plan
        reported = threading.Event()

        def endless(*_, progress, **__):
            while True:
                progress(0.5, "looking for a first path")
                reported.set()
                time.sleep(0.01)

        monkeypatch.setattr(replanner, "plan", endless)
        again.plan()
        assert reported.wait(10)
        assert "Looking for a first path" in again.text
        again.stop()
        assert not again.planning
        assert "Stopped" in again.text and live.motion.plan is made
        reported.clear()
        again.plan()
        assert reported.wait(10)
    assert not live.running  # a page that plans can be closed


def test_a_stop_between_two_steps_of_the_planner_counts_at_once(plan, monkeypatch):
    """What the planner returns afterwards is dropped, and planning again waits for it."""
    begun, go_on = threading.Event(), threading.Event()

    def slow(*_, **__):
        begun.set()
        assert go_on.wait(10)
        return replace(plan, goal_index=0)

    monkeypatch.setattr(replanner, "plan", slow)
    with plan.show(port=0, open_browser=False) as live:
        again = live.replanner
        again.plan()
        assert begun.wait(10)
        begun.clear()
        again.stop()
        assert not again.planning and again.text == replanner.STOPPED
        again.plan()
        assert again.planning and not begun.wait(0.5)
        again.stop()
        go_on.set()
        assert not begun.wait(0.5)
        assert live.motion.plan is plan and again.text == replanner.STOPPED
        again.plan()
        wait_until(lambda: live.motion.plan is not plan)
        wait_until(lambda: not again.planning)


def test_only_a_plan_to_a_goal_can_be_planned_again(plan):
    followed = replace(plan, workspace_path=mp.CartesianPath.line(np.eye(4), pin.SE3(np.eye(3), np.array([0.1, 0, 0]))))
    with followed.show(port=0, open_browser=False) as live:
        assert live.replanner is None


@pytest.mark.parametrize(("width", "height"), [(760, 600), (390, 800)])
@pytest.mark.parametrize("kind", ["live", "recorded"])
def test_the_panel_stands_beside_the_scene_or_below_it(plan, shown, browser, tmp_path, kind, width, height):
    url = shown.url if kind == "live" else plan.record(tmp_path / "motion.html").as_uri()
    context = browser.new_context(viewport={"width": width, "height": height}, color_scheme="dark")
    try:
        page = context.new_page()
        page.set_default_timeout(120_000)  # [ms]
        page.goto(url)
        chart, canvas = page.locator("svg[data-time]"), page.locator("canvas").first
        chart.wait_for()
        settled(page)
        scene, own = canvas.bounding_box(), chart.bounding_box()
        if width > 576:
            assert scene["x"] + scene["width"] <= own["x"] + 1 and scene["width"] > 0.5 * width
        else:
            assert scene["y"] + scene["height"] <= own["y"] + 1 and scene["height"] > 0.3 * height
        assert page.evaluate("document.documentElement.scrollWidth") <= width
        assert page.evaluate("document.documentElement.dataset.mantineColorScheme") == "dark"
        assert page.title() == plan.robot.name
    finally:
        context.close()


def test_a_notebook_shows_a_recording_without_a_server(plan, open_page, tmp_path, monkeypatch):
    monkeypatch.setitem(sys.modules, "IPython", None)
    cell = viewer.embed(plan, height=300)
    assert len(cell.html) < 1_500_000 and "MB" in repr(cell)
    file = tmp_path / "cell.html"
    file.write_text(f"<body><canvas width=1 height=1></canvas>{cell._repr_html_()}</body>")
    page = open_page(file.as_uri())
    frame = page.frame_locator("iframe")
    frame.locator("#recorded svg polyline").first.wait_for()
    before = frame.locator(".now").get_attribute("x1")
    wait_until(lambda: frame.locator(".now").get_attribute("x1") != before)
    for wrong in (0, 1e9, "tall"):
        with pytest.raises(mp.errors.InvalidInputError, match="height"):
            viewer.embed(plan, height=wrong)


def test_the_seed_is_where_it_has_covered_the_same_share_of_its_length(shown, plan):
    t = 0.4 * plan.trajectory.duration
    shown.time = t
    covered = plan.trajectory(np.linspace(0, t, 4000))
    share = np.linalg.norm(np.diff(covered, axis=0), axis=1).sum() / plan.trajectory.path().length
    s = np.linspace(0, 1, 4001)
    steps = np.linalg.norm(np.diff(plan.result.seed(s), axis=0), axis=1)
    there = np.interp(share, np.append(0, np.cumsum(steps)) / steps.sum(), s)
    np.testing.assert_allclose(shown.motion.seed.at(t), plan.result.seed(there), atol=2e-3)
    np.testing.assert_allclose(
        tool_of(shown.stage.figures[1].robot), last_joint(plan.robot, shown.motion.seed.at(t)), atol=1e-9
    )


def test_a_recording_plays_without_a_network(plan, open_page, tmp_path):
    file = plan.record(tmp_path / "motion.html")
    text = file.read_text()
    assert len(text) < 1_500_000
    page = open_page(file.as_uri())  # which fails at the end where anything else was asked for
    first = drawn(page)
    drawn(page, differs_from=first)

    def shown_now():
        """Time of viser's player, that of the panel, the mark's place and the height of the last dot, our curve's."""
        return page.evaluate(
            """() => [Number(document.querySelector('[role=slider]').getAttribute('aria-valuenow')),
            parseFloat(document.querySelector('#recorded td:last-child').textContent),
            Number(document.querySelector('.now').getAttribute('x1')),
            Number([...document.querySelectorAll('#recorded circle')].at(-1).getAttribute('cy'))]"""
        )

    def follows():
        player, panel, mark, height = shown_now()
        player, chart = min(player, plan.trajectory.duration), chart_of(ShownMotion.of(plan))
        [own] = re.findall(r'<line class="now" x1="([^"]+)"', chart.svg(panel))
        at = re.findall(r'<circle cx="[^"]+" cy="([^"]+)"', chart.svg(panel))[-1]
        return abs(player - panel) < 0.1 and abs(mark - float(own)) < 2 and abs(height - float(at)) < 2

    wait_until(follows)
    before = shown_now()[2]
    wait_until(lambda: abs(shown_now()[2] - before) > 10)
    page.keyboard.press("Space")
    assert page.locator("#recorded svg polyline").count() == 2
    motion = ShownMotion.of(plan)
    page.get_by_role("button", name="Worst moment").click()
    wait_until(lambda: abs(shown_now()[0] - motion.worst) < 0.02)
    wait_until(
        lambda: (
            page.locator("#recorded td:last-child").all_text_contents()[1:3]
            == [value for _, value in motion.values(motion.worst)[1:3]]
        )
    )
    click_in_chart(page, 0.25, lambda: abs(shown_now()[0] - 0.25 * plan.trajectory.duration) < 0.05)
    no_serious_fault(page)
    with pytest.raises(mp.errors.InvalidInputError, match="rate"):
        viewer.record(plan, tmp_path / "motion.html", rate=0)
    with pytest.raises(mp.errors.InvalidInputError, match="file"):
        plan.record(tmp_path / "nowhere" / "motion.html")
    for name in (tmp_path / "motion.txt", tmp_path / "motion", tmp_path, 7, ""):
        with pytest.raises(mp.errors.InvalidInputError, match="file: got .* ends in .html"):
            plan.record(name)
    assert [file.name for file in tmp_path.iterdir()] == ["motion.html"]


def test_a_dragged_target_is_followed(open_page):
    robot = mp.planar_arm([1.0, 0.8, 0.6])
    with viewer.follow_target(robot, start=[0.3, 0.8, 0.9], port=0, open_browser=False) as live:
        page = open_page(live.url)
        before = drawn(page)
        goal = live.target
        goal[:3, 3] += [-0.3, 0.2, 0.0]
        live.target = goal
        wait_until(lambda: np.linalg.norm(live.pose[:3, 3] - goal[:3, 3]) < 2e-3)
        wait_until(lambda: abs(tool_of(live.robot) - last_joint(robot, live.q)).max() < 1e-6)
        drawn(page, differs_from=before)
        page.locator(".mantine-Notification-closeButton").click()  # it tells that there is no graphics card
        [client] = live.server.get_clients().values()

        def places():
            at, size = live.target[:3, 3], live.handle.scale
            return [project(client.camera, page, [x + 0.6 * size, *at[1:]]) for x in (at[0], goal[0, 3] - 0.5)]

        drag(page, places, lambda: live.target[0, 3] < goal[0, 3] - 0.3)
        np.testing.assert_allclose(live.target[1:3, 3], goal[1:3, 3], atol=1e-6)
        wait_until(lambda: np.linalg.norm(live.pose[:3, 3] - live.target[:3, 3]) < 2e-3)
        assert (np.abs(live._qd) <= robot.limits.velocity + 1e-9).all()
        page.get_by_role("button", name="Back to the start").click()
        wait_until(lambda: np.abs(live.target[:3, 3] - robot.kinematics().pose([0.3, 0.8, 0.9])[:3, 3]).max() < 1e-9)
        page.get_by_role("checkbox").first.click(force=True)
        wait_until(lambda: live.drive == 0.0)
        live.drive = 0.5
        wait_until(page.get_by_role("checkbox").first.is_checked)
        assert live.drive == 0.5
        with pytest.raises(mp.errors.InvalidInputError, match="target"):
            live.target = np.zeros((4, 4))
    assert not live.running


def project(camera, page, point):
    """Where the browser draws a point of the world [px]."""
    canvas = page.locator("canvas").first.bounding_box()
    w, x, y, z = camera.wxyz
    view = pin.Quaternion(w, x, y, z).toRotationMatrix().T @ (np.asarray(point) - camera.position)
    scale = canvas["height"] / 2 / np.tan(camera.fov / 2)
    return canvas["x"] + canvas["width"] / 2 + scale * view[0] / view[2], canvas["y"] + canvas["height"] / 2 + scale * view[
        1
    ] / view[2]


#: A key is tapped so soon after a click that viser drops messages between.
CLICK_AND_TAP = """
[...document.querySelectorAll('button')].find(button => button.textContent.includes('Back to the start')).click();
for (const type of ['keydown', 'keyup']) document.body.dispatchEvent(new KeyboardEvent(type, {key: 'j', bubbles: true}));
"""


def test_keys_and_buttons_move_the_tool_through_the_edge_of_its_reach(open_page):
    robot = mp.planar_arm([1.0, 0.8, 0.6])
    with viewer.teleoperate(robot, start=[0.3, 0.8, 0.9], dt=0.01, port=0, open_browser=False) as live:
        page = open_page(live.url)
        drawn(page)
        page.locator(".mantine-Notification-closeButton").click()  # it tells that there is no graphics card
        axes, speed = page.locator("input[aria-haspopup=listbox]:visible"), page.locator("input:visible").first
        assert (axes.input_value(), speed.input_value()) == ("world", "0.1")
        live.speed, live.frame = 0.4, "tool"
        wait_until(lambda: (axes.input_value(), speed.input_value()) == ("tool", "0.4"))
        axes.click()
        page.get_by_role("option", name="world").click()
        wait_until(lambda: live.frame == "world")
        assert live.speed == 0.4
        assert page.evaluate("document.activeElement.localName") == "input"  # whose focus takes no key
        before = live.pose[:3, 3]
        page.keyboard.press("j")
        wait_until(lambda: live.pose[1, 3] > before[1] + 0.01)
        wait_until(lambda: not live.twist.any())
        np.testing.assert_allclose(live.pose[0, 3], before[0], atol=0.02)
        page.keyboard.down("j")
        page.keyboard.down("i")  # a keyboard repeats only the last one; both count
        wait_until(lambda: live.twist[:2].min() > 0)
        wait_until(lambda: live.gauge.wall > 0.5)
        assert live.gauge.kind.name == "FOLD" and live.gauge.status == 0
        stretched = np.linalg.norm(live.pose[:2, 3])
        assert 2.35 < stretched <= 2.4
        page.keyboard.up("i")
        wait_until(lambda: live.twist[0] == 0 < live.twist[1])
        page.evaluate("dispatchEvent(new Event('blur'))")  # to another window: the key comes up there
        wait_until(lambda: not live.twist.any())
        page.keyboard.up("j")
        wait_until(lambda: "edge of the reach" in page.locator("body").inner_text())
        button = page.get_by_role("button", name="K: backward, -x")
        button.scroll_into_view_if_needed()
        place = button.bounding_box()
        page.mouse.move(place["x"] + place["width"] / 2, place["y"] + place["height"] / 2)
        page.mouse.down()
        wait_until(lambda: np.linalg.norm(live.pose[:2, 3]) < stretched - 0.2)
        page.mouse.up()
        wait_until(lambda: not live.twist.any())
        wait_until(lambda: abs(tool_of(live.robot) - last_joint(robot, live.q)).max() < 1e-6)
        assert (np.abs(live._qd) <= robot.limits.velocity + 1e-9).all()
        page.get_by_role("button", name="Back to the start").click()
        wait_until(lambda: np.abs(live.q - [0.3, 0.8, 0.9]).max() < 1e-9)
        page.evaluate(CLICK_AND_TAP)
        wait_until(lambda: live.pose[1, 3] > before[1] + 0.01)
        wait_until(lambda: not live.twist.any())
    assert not live.running


def test_a_gauge_in_words():
    """As many rows at each step: buttons are below them."""
    servo = mp.Servo(mp.planar_arm([1.0, 1.0]), dt=0.01)
    q, qd, seen = np.array([0.0, 0.8]), np.zeros(2), []
    for k in range(400):
        qd = servo.step(q, qd, [1.0, 0, 0, 0, 0, 0] if k < 300 else None)
        q = q + servo.dt * qd
        seen.append(dict(gauge_rows(servo.gauge)))
    names = ["followed", "singularity ahead", "reached in", "edge of the reach", "limited by"]
    assert all(list(each) == names and each["followed"][:2] != "-0" for each in seen)
    assert seen[0]["limited by"].startswith("acceleration joint") and seen[-1]["limited by"] == "stale: the arm brakes"
    assert re.fullmatch("fold of joint.", seen[299]["singularity ahead"]) and seen[299]["reached in"] == "0.0 s, 0 mm"
    still = servo.gauge._replace(followed=-1e-4)
    assert dict(gauge_rows(still))["followed"] == "0 %, sideways 0 %"


@pytest.mark.slow
def test_a_program_moves_the_tool_until_its_command_is_stale():
    with viewer.teleoperate(mp.planar_arm([1.0, 0.8, 0.6]), start=[0.3, 0.8, 0.9], port=0, open_browser=False) as live:
        before, end = live.pose[0, 3], time.monotonic() + 30.0
        while live.pose[0, 3] > before - 0.1:
            live.twist = [-0.3, 0.0, 0.0, 0.0, 0.0, 0.0]
            assert time.monotonic() < end
            time.sleep(0.02)
        wait_until(lambda: live.gauge.status.name == "STALE")
        wait_until(lambda: not live._qd.any())
        live.press(0, 1, seconds=0.2)  # a key takes over
        wait_until(lambda: live.gauge.status.name == "FOLLOWING")
        live.frame = "tool"
        live.twist = np.full(6, np.nan)
        wait_until(lambda: live.gauge.status.name in ("BAD_COMMAND", "STALE"))
        for argument, value in (("twist", [1.0, 0.0]), ("twist", "fast"), ("frame", "camera"), ("frame", 3)):
            with pytest.raises(mp.errors.InvalidInputError, match=argument):
                setattr(live, argument, value)
    for argument, value in (("robot", "panda"), ("start", [0.0]), ("dt", 0.0), ("side", "left"), ("scene", 3), ("port", -1)):
        with pytest.raises(mp.errors.InvalidInputError, match=argument):
            viewer.teleoperate(**{"robot": mp.planar_arm([1.0, 1.0]), "port": 0, "open_browser": False} | {argument: value})


@pytest.mark.slow
def test_the_arm_follows_among_obstacles_with_a_prismatic_joint():
    robot = mp.load_robot("tiago")
    assert "prismatic" in robot.joint_types
    live = viewer.follow_target(robot, mp.formulations.Classical(gain=1.0), port=0, open_browser=False)
    try:
        goal = live.target
        goal[:3, 3] += [0.02, 0.05, -0.05]
        live.target = goal
        wait_until(lambda: np.linalg.norm(live.pose[:3, 3] - goal[:3, 3]) < 2e-3)
    finally:
        live.stop()
    with pytest.raises(mp.errors.InvalidInputError, match="Classical"):
        viewer.follow_target(
            robot,
            mp.formulations.Classical(gain=1.0),
            scene=mp.Scene([mp.Sphere(radius=0.1, position=(1, 1, 1))]),
            port=0,
            open_browser=False,
        )


@pytest.mark.slow
def test_visual_meshes_stand_where_pinocchio_puts_them(plan):
    robot = mp.load_robot("panda")
    plan = moved(plan, robot)
    appearance = appearance_of(robot)
    assert appearance.origin == "visual meshes"
    by_name = {name: list(parts) for name, parts in groupby(appearance.bodies, key=lambda body: body.name)}  # one per colour
    assert max(sum(len(body.faces) for body in parts) for parts in by_name.values()) <= MOST
    with plan.show(port=0, open_browser=False) as page:
        page.time = 0.7 * plan.trajectory.duration
        q = plan.trajectory(page.time)
        whole = pin.buildModelFromUrdf(str(robot.source.file))
        folders = [str(folder) for folder in robot.source.file.parents]
        geometry = pin.buildGeomFromUrdf(whole, str(robot.source.file), pin.GeometryType.VISUAL, package_dirs=folders)
        posture = np.append(q, [robot.locked[name] for name in list(whole.names)[8:]])
        data, placed = whole.createData(), pin.GeometryData(geometry)
        pin.updateGeometryPlacements(whole, data, geometry, placed, posture)
        assert list(by_name) == [item.name for item in geometry.geometryObjects]
        for parts, item, placement in zip(by_name.values(), geometry.geometryObjects, placed.oMg, strict=True):
            frame = page.stage.figures[0].robot.frames[parts[0].joint]
            turn = pin.Quaternion(*(float(c) for c in frame.wxyz)).toRotationMatrix()
            ours = np.concatenate([body.vertices for body in parts]) @ turn.T + frame.position
            theirs = np.array(item.geometry.vertices()) @ placement.rotation.T + placement.translation
            for side in (np.min, np.max):
                # corners in one cell of some millimetres become their mean
                np.testing.assert_allclose(side(ours, axis=0), side(theirs, axis=0), atol=5e-3)


ARM = """<robot name="arm"><link name="base"/><link name="rod">{visual}{collision}</link><link name="slide"/><link name="lift"/><link name="tip"/>
<joint name="turn" type="revolute"><parent link="base"/><child link="rod"/><axis xyz="0 0 1"/>
<limit lower="-2" upper="2" velocity="1" effort="1"/></joint>
<joint name="out" type="prismatic"><parent link="rod"/><child link="slide"/><origin xyz="0.4 0 0.1"/><axis xyz="1 0 0"/>
<limit lower="0" upper="0.3" velocity="1" effort="1"/></joint>
<joint name="up" type="prismatic"><parent link="slide"/><child link="lift"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" velocity="1" effort="1"/></joint>
<joint name="end" type="fixed"><parent link="lift"/><child link="tip"/><origin xyz="0.2 0 0"/></joint></robot>"""
BOX = '<{0}><geometry><box size="0.4 0.1 0.1"/></geometry></{0}>'


@pytest.mark.parametrize(
    ("visual", "collision", "origin"),
    [
        (BOX.format("visual"), "", "visual meshes"),
        ('<visual><geometry><mesh filename="gone.stl"/></geometry></visual>', BOX.format("collision"), "cannot be read"),
        ("", BOX.format("collision"), "no visual geometry"),
        ("", "", "rods from joint to joint"),
    ],
)
def test_what_cannot_be_read_is_replaced_and_told(plan, tmp_path, caplog, visual, collision, origin):
    file = tmp_path / "arm.urdf"
    file.write_text(ARM.format(visual=visual, collision=collision))
    robot = mp.Robot.from_urdf(file, tool="tip")
    plan = moved(plan, robot, start=[0.1, 0.1, 0.1])
    with caplog.at_level(logging.INFO, logger="manipplan"), plan.show(port=0, open_browser=False) as page:
        told = appearance_of(robot).origin
        assert origin in told
        assert origin == "visual meshes" or told in caplog.text
        assert any(told in str(message) for message in page.server._websock_server._broadcast_buffer.message_from_id.values())
        assert ("nearest limit", "out at 0.100 m from its lower limit") in page.motion.values(0.0)


def test_every_kind_of_obstacle_is_drawn(plan, tmp_path):
    trimesh.creation.box((0.2, 0.2, 0.2)).export(tmp_path / "part.stl")
    scene = mp.Scene(
        [
            mp.Sphere(radius=0.1, position=(0.9, 0.9, 0.1)),
            mp.Capsule(radius=0.05, length=0.2, position=(-0.9, 0.9, 0.1)),
            mp.Cylinder(radius=0.05, length=0.2, position=(-0.9, -0.9, 0.1)),
            mp.Mesh(file=tmp_path / "part.stl", position=(0.9, -0.9, 0.1), rotation=(0.0, 0.0, 0.5), name="<part>"),
            mp.Plane(position=(0.0, 0.0, -0.3), name="ground"),
        ]
    )
    plan = moved(plan, mp.planar_arm([0.4, 0.4]), scene=scene)
    with plan.show(port=0, open_browser=False) as page:
        lower, upper = surface(page, "/obstacles/3", "/obstacles/3/0")
        size = 0.2 * (np.cos(0.5) + np.sin(0.5))
        np.testing.assert_allclose(upper - lower, [size, size, 0.2], atol=1e-6)
        np.testing.assert_allclose((upper + lower) / 2, [0.9, -0.9, 0.1], atol=1e-6)
        names = [page.server.scene.get_handle_by_name(f"/obstacles/names/{k}") for k in range(5)]
        assert [name.text for name in names] == ["sphere0", "capsule1", "cylinder2", "<part>", "ground"]
        assert names[0].position[2] > 0.2  # above the sphere
        assert page.stage.layers["grid"].position[2] < -0.02


def test_clouds_are_drawn_as_points():
    from manipplan.viz.viewer.stage import POINTS, ObstaclesFigure

    server = viser.ViserServer(port=0, verbose=False)
    try:
        points = np.random.default_rng(0).random((9000, 3))
        scene = mp.Scene([mp.PointCloud(points=points, radius=0.01, position=(2, 0, 0), name="scan")])
        figure = ObstaclesFigure(server.scene, "/obstacles", scene)
        node = server.scene.get_handle_by_name("/obstacles/0/0")
        assert len(node.points) == POINTS and node.point_size == pytest.approx(0.02) and figure.frames[0].position[0] == 2.0
        seen = points.min(axis=0) + [2, 0, 0], points.max(axis=0) + [2, 0, 0]
        np.testing.assert_allclose([figure.points.min(axis=0), figure.points.max(axis=0)], seen)
        label = server.scene.get_handle_by_name("/obstacles/names/0").position  # above the points, not above the camera
        np.testing.assert_allclose(label, [*((seen[0] + seen[1])[:2] / 2), seen[1][2] + 0.02], rtol=1e-6)
    finally:
        server.stop()


def surface(page, frame, name):
    """Corners of a node of the scene in the world, and the frame in which it is drawn."""
    frame, node = (page.server.scene.get_handle_by_name(each) for each in (frame, name))
    turn = pin.Quaternion(*(float(c) for c in frame.wxyz)).toRotationMatrix()
    placed = np.asarray(node.vertices) @ turn.T + frame.position
    return placed.min(axis=0), placed.max(axis=0)


@pytest.mark.parametrize(
    ("shape", "volume", "size"),
    [
        (coal.Box(0.2, 0.4, 0.6), 0.048, (0.2, 0.4, 0.6)),
        (coal.Sphere(0.5), np.pi / 6, (1, 1, 1)),
        (coal.Ellipsoid(0.5, 0.25, 0.1), 4 / 3 * np.pi * 0.0125, (1, 0.5, 0.2)),
        (coal.Capsule(0.1, 0.5), np.pi * 0.01 * (0.5 + 4 / 30), (0.2, 0.2, 0.7)),
        (coal.Cylinder(0.1, 0.5), np.pi * 0.005, (0.2, 0.2, 0.5)),
        (coal.Cone(0.1, 0.6), np.pi * 0.002, (0.2, 0.2, 0.6)),
    ],
)
def test_shapes_are_drawn_in_their_size(shape, volume, size):
    vertices, faces = triangles_of(shape)
    drawn_shape = trimesh.Trimesh(vertices=vertices, faces=faces)
    assert abs(drawn_shape.volume / volume - 1) < 0.02
    np.testing.assert_allclose(np.ptp(vertices, axis=0), size, rtol=5e-3)
    shape.computeLocalAABB()
    np.testing.assert_allclose(vertices.min(axis=0), np.array(shape.aabb_local.min_), atol=3e-3)


def test_the_chart_numbers_the_steps_of_a_program():
    """Steps that begin together share a place, and the number of the first is written."""
    t = np.linspace(0.0, 10.0, 5)
    marks = [(0.0, "1 MoveTo"), (5.0, "2 Attach"), (5.1, "3 MoveAlong"), (8.0, "4 MoveTo <b>")]
    svg = Chart(t=t, curves=[ChartLine(name="m", colour="#000000", values=t)], label="m", marks=marks, seeks=True).svg(0.0)
    assert re.findall(r'text-anchor="middle">(\d)</text></g>', svg) == ["1", "2", "4"]
    assert svg.count('class="mark"') == 4 and "<b>" not in svg and 'data-time="[' in svg


def test_the_chart_marks_the_place():
    chart = Chart(
        t=np.linspace(0, 2, 5), curves=[ChartLine(name="a<b", colour="#123456", values=np.array([0, 1, 2, 1, 0.0]))], label="m"
    )
    assert 'class="now"' not in chart.svg()
    left, right = (float(chart.svg(t).split('class="now" x1="')[1].split('"')[0]) for t in (0.0, 2.0))
    middle = float(chart.svg(1.0).split('class="now" x1="')[1].split('"')[0])
    assert left < middle < right
    assert abs(middle - (left + right) / 2) < 0.06
    assert "<b" not in chart.html()


@pytest.mark.parametrize(("first", "last"), [(-9.0, -4.0), (-1.0, 2.0), (0.0, 0.0), (1e-17, 1e-17), (0.0, 3.0)])
def test_the_chart_holds_its_curves(first, last):
    """Also those of a logarithm, which are negative."""
    t = np.linspace(0.0, 1.0, 5)
    svg = Chart(t=t, curves=[ChartLine(name="a", colour="#000000", values=np.linspace(first, last, 5))], label="log_det").svg(
        0.5
    )
    places = [float(place.partition(",")[2]) for place in re.search(r'polyline points="([^"]*)"', svg)[1].split()]
    assert 10 <= min(places) <= max(places) <= 140
    assert np.sign(places[0] - places[-1]) == np.sign(last - first)


@pytest.mark.slow
def test_a_port_in_use_is_an_error(plan):
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = taken.getsockname()[1]
        with pytest.raises(mp.errors.InvalidInputError, match=rf"port: got {port}.*in use.*any free one"):
            plan.show(port=port, open_browser=False)
    with plan.show(port=port, open_browser=False) as page:
        assert page.url == f"http://localhost:{port}"
        with pytest.raises(mp.errors.InvalidInputError, match="in use"):
            plan.show(port=port, open_browser=False)
    with plan.show(port=port, open_browser=False):  # free again at once
        pass


@pytest.mark.parametrize(
    ("argument", "value"),
    [
        ("port", 70_000),
        ("port", "x"),
        ("host", ""),
        ("host", "no.such.host.invalid"),
        ("host", "192.0.2.1"),
        ("open_browser", 1),
    ],
)
def test_other_bad_arguments(plan, argument, value):
    with pytest.raises(mp.errors.InvalidInputError, match=argument):
        plan.show(**{"open_browser": False, "port": 0, argument: value})


def test_a_plan_without_a_motion_is_an_error(plan):
    failed = mp.results.PartialPlan(
        robot=plan.robot, scene=plan.scene, status=Status.NO_PATH, message="the goal is in the wall"
    )
    for work, show in (
        ("no trajectory to show", lambda: failed.show(port=0)),
        ("no trajectory to record", lambda: failed.record("x.html")),
        ("no trajectory to show", lambda: viewer.show(failed, port=0)),
        ("no trajectory to show", lambda: viewer.record(failed, "x.html")),
    ):
        with pytest.raises(mp.errors.PlanningError, match=f"{work}: the goal is in the wall") as caught:
            show()
        assert caught.value.result is failed


@pytest.mark.slow
def test_a_speed_that_is_none_does_not_end_the_play(plan):
    with plan.show(port=0, open_browser=False) as page:
        for value in (-3.0, 0, "fast", np.nan):
            with pytest.raises(mp.errors.InvalidInputError, match="speed"):
                page.speed = value
        page.speed = 0.5
        page.play()
        wait_until(lambda: page.time > 0.1)
    with viewer.follow_target(mp.planar_arm([1.0, 1.0]), port=0, open_browser=False) as page:
        for value in (-1.0, "much", np.inf):
            with pytest.raises(mp.errors.InvalidInputError, match="drive"):
                page.drive = value
    with viewer.teleoperate(mp.planar_arm([1.0, 1.0]), port=0, open_browser=False) as page:
        for value in (0.0, "fast", np.nan):
            with pytest.raises(mp.errors.InvalidInputError, match="speed"):
                page.speed = value
        page.speed = 2.0  # beyond the slider's end
        assert page.speed == 2.0


def test_a_page_may_end_itself(plan, monkeypatch):
    """From the thread that plays: it cannot wait for itself."""
    page = plan.show(port=0, open_browser=False)
    ended = []
    monkeypatch.setattr(page, "_show", lambda t: ended.append(page.stop()))
    page.play()
    wait_until(lambda: ended)
    wait_until(lambda: not any(thread.is_alive() for thread in page._threads))
    assert not page.running
    with socket.socket() as probe:
        assert probe.connect_ex(("127.0.0.1", page.server.get_port())) != 0


def test_a_page_that_cannot_be_filled_leaves_its_port(plan, monkeypatch):
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    monkeypatch.setattr(plan_viewer, "about", lambda motion: 1 / 0)
    with pytest.raises(ZeroDivisionError):
        plan.show(port=port, open_browser=False)
    monkeypatch.undo()
    with plan.show(port=port, open_browser=False) as page:
        assert page.running


def test_the_address_of_ipv6_is_one(plan):
    try:
        with socket.socket(socket.AF_INET6) as probe:
            probe.bind(("::1", 0))
    except OSError:
        pytest.skip("this machine has no IPv6")
    with plan.show(port=0, host="::1", open_browser=False) as page:
        assert urllib.request.urlopen(page.url, timeout=10).status == 200


def test_a_motion_of_other_joints_is_told(plan):
    other = moved(plan, mp.planar_arm([1.0, 1.0]))
    with pytest.raises(
        mp.errors.InvalidInputError, match=r"plan.trajectory: got 'a motion of 2 joints'; allowed: one of the robot's 3"
    ):
        replace(other, robot=plan.robot).show(port=0, open_browser=False)


def test_without_a_browser_the_address_is_told(plan, monkeypatch, caplog):
    for name in ("DISPLAY", "WAYLAND_DISPLAY", "BROWSER"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(pages.webbrowser, "open", lambda url: pytest.fail("a text browser would take the terminal"))
    with plan.show(port=0) as page:
        assert f"open {page.url} in one yourself" in caplog.text
        monkeypatch.setenv("DISPLAY", ":0")
        monkeypatch.setattr(pages.webbrowser, "open", lambda url: False)
        assert page.open() is False
        opened = []
        monkeypatch.setattr(pages.webbrowser, "open", lambda url: opened.append(url) or True)
        assert page.open() is True
        assert opened == [page.url]


def test_without_the_extra_the_install_line_is_told(plan, monkeypatch):
    monkeypatch.setitem(sys.modules, "viser", None)
    with pytest.raises(mp.errors.MissingExtraError, match=r"viser is not installed; .*'manipplan\[viewer\]'"):
        plan.show(port=0)
    with pytest.raises(mp.errors.MissingExtraError):
        plan.record("x.html")


@pytest.mark.slow
def test_importing_it_imports_no_viewer():
    code = "import sys, manipplan, manipplan.viz.viewer; sys.exit(bool({'viser', 'trimesh', 'matplotlib'} & set(sys.modules)))"
    assert subprocess.run([sys.executable, "-c", code], check=False).returncode == 0


@pytest.mark.slow
def test_view_from_a_shell(plan, tmp_path, capsys, sigint):
    plan.save(tmp_path)
    assert main(["view", str(tmp_path), "--record", str(tmp_path / "motion.html")]) == 0
    assert (tmp_path / "motion.html").stat().st_size > 500_000
    assert "motion.html" in capsys.readouterr().out
    process = subprocess.Popen(
        [sys.executable, "-u", "-m", "manipplan", "view", str(tmp_path), "--port", "0", "--no-browser"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        env={**os.environ, "COLUMNS": "200", "CC": ""},  # a $CC that does not work would be reported
    )
    try:
        line = process.stdout.readline()
        with urllib.request.urlopen(line.split(" at ")[1].split(";")[0], timeout=10) as answer:
            assert answer.status == 200
        process.send_signal(signal.SIGINT)
        out, error = process.communicate(timeout=20)
    finally:
        process.kill()
    assert (process.returncode, out) == (0, "")
    assert all(line.startswith("... ") for line in error.splitlines())  # the progress


@pytest.mark.slow
def test_a_port_in_use_is_one_line_in_a_shell(plan, tmp_path, capsys):
    plan.save(tmp_path)
    capsys.readouterr()
    with socket.socket() as taken:
        taken.bind(("127.0.0.1", 0))
        taken.listen()
        port = str(taken.getsockname()[1])
        assert main(["view", str(tmp_path), "--port", port, "--no-browser"]) == 2
    [error] = [line for line in capsys.readouterr().err.splitlines() if not line.startswith("...")]
    assert error.startswith(f"manipplan: port: got {port}") and "0 for any free one" in error


def test_a_broken_result_is_told(tmp_path, capsys):
    assert main(["view", str(tmp_path / "nothing")]) == 2
    (tmp_path / "plan.json").write_text('{"cut off": ')
    assert main(["view", str(tmp_path), "--no-browser"]) == 2
    assert "plan.json" in capsys.readouterr().err
