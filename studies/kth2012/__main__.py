"""`python -m studies.kth2012 [--quick] [--out DIR]`: all tables and figures of the study."""

from studies.kth2012.run import main

if __name__ == "__main__":
    main()
