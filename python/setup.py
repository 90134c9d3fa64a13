"""Makes the wheel of the package in the build folder. The wheel is for this platform, because the package has a compiled module."""

import setuptools


class Platform(setuptools.Distribution):
    def has_ext_modules(self):
        return True


setuptools.setup(distclass=Platform)
