bool pays(double, double, double) { return true; }
