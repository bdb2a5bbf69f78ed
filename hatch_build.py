"""Builds the library of kernels into the package; without a C compiler the package compiles them by LLVM, at first use."""

import os
import runpy
import sysconfig
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class KernelHook(BuildHookInterface):
    """A wheel with the library is one for this platform. $MANIPPLAN_PURE=1 makes one without it, for all platforms."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build the library, and say that the wheel holds it."""
        if os.environ.get("MANIPPLAN_PURE") == "1":
            return
        build = runpy.run_path(str(Path(self.root, "manipplan", "support", "kernel_library.py")))
        try:
            file = build["build_library"]()
        except OSError as error:
            self.app.display_warning(f"the kernels are not built, LLVM will compile them at first use: {error}")
            return
        if version != "editable":
            build_data["artifacts"].append(f"/manipplan/csrc/{file.name}")
            platform = sysconfig.get_platform().replace("-", "_").replace(".", "_")
            build_data["pure_python"], build_data["tag"] = False, f"py3-none-{platform}"
