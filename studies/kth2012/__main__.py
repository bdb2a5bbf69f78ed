"""`python -m studies.kth2012 [--quick] [--out DIR]`: all tables and figures of the study."""

import sys

from studies.kth2012.run import STUDY

if __name__ == "__main__":
    sys.exit(bool(STUDY.main()))
