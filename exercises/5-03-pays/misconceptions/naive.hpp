bool pays(double cBox, double cObj, double) { return cBox < cObj; }
