// This program runs the four processes of bench/commstime.cpp as goroutines of one thread. Go has no virtual time.
package main

import (
	"fmt"
	"runtime"
	"syscall"
)

func processorTime() int64 {
	var usage syscall.Rusage
	syscall.Getrusage(syscall.RUSAGE_SELF, &usage)
	return usage.Utime.Nano() + usage.Stime.Nano()
}

func main() {
	const loops = 1000000
	runtime.GOMAXPROCS(1)
	a, b, c, d := make(chan int), make(chan int), make(chan int), make(chan int)
	go func() {
		a <- 0
		for {
			a <- <-b
		}
	}()
	go func() {
		for {
			x := <-a
			c <- x
			d <- x
		}
	}()
	go func() {
		for {
			b <- <-c + 1
		}
	}()
	start := processorTime()
	for i := 0; i < loops; i++ {
		if <-d != i {
			panic("a number is missing")
		}
	}
	fmt.Printf("Go %-29s %8.1f ns/loop\n", "no time passing", float64(processorTime()-start)/loops)
}
