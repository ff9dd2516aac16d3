# A heuristic of one's own, measured along a flight beside the published one: ./run python examples/python/own_heuristic.py
# SPDX-License-Identifier: GPL-3.0-or-later
import sys

import numpy as np
import sightline


def crowd(facet):
    """The crowd met on the way: nothing fades, as it does with the published solidity."""
    return facet.handed_on + facet.content


def coverages(scene, path, frames, **settings):
    session = sightline.open_3d(scene, budget="5%", **settings)
    views = session.paths[path]
    found = []
    for i in np.linspace(0, len(views) - 1, frames).astype(int):
        session.look(*views[i])
        session.run()
        found.append(session.coverage)
    return np.array(found)


scene, path, frames = (sys.argv[1:] + ["city:10k", "street", "4"][len(sys.argv) - 1 :])[:3]
for name, settings in {
    "crowd": dict(method=crowd, on_reenqueue="min"),
    "published": dict(method="published"),
    "layers": dict(method="layers"),
}.items():
    coverage = coverages(scene, path, int(frames), **settings)
    print(f"{name:10} coverage {np.median(coverage):.3f} (median), {coverage.min():.3f} (lowest)")
