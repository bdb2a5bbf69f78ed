"""`python -m studies.singularities [--out DIR]`: all tables and figures of the study."""

import sys

from studies.singularities.run import STUDY

if __name__ == "__main__":
    sys.exit(bool(STUDY.main()))
