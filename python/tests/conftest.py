"""What the tests share."""

import pytest
from small_scene import BALL

import sunfleck


@pytest.fixture(scope="session")
def scene():
    return sunfleck.Scene.parse(BALL)
