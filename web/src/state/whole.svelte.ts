/** The view alone, without the front plate of the CPU and the head of the page. */
class Whole {
  on = $state(false);
}
export const whole = new Whole();
